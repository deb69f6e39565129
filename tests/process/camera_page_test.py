#!/usr/bin/python3
"""What a browser gets from eod-console while eod-sim draws: the page, and pictures as they come."""

import re
import sys
import unittest
import urllib.request

from programs import Chain


def pictures(stream, count):
    """The next JPEGs of a multipart stream."""
    for _ in range(count):
        while not (line := stream.readline()).startswith(b"Content-Length:"):
            assert line, "the stream goes on"
        size = int(line.split(b":")[1])
        assert stream.readline() == b"\r\n"
        yield stream.read(size)


class CameraPage(unittest.TestCase):
    def test_browser_sees_the_chosen_camera_and_the_one_beside_it(self):
        with Chain("", programs=("eod-sim", "eod-console"), cameras=True,
                   eod_console=("--port", "0")) as chain:
            url = re.search(r"http://127\.0\.0\.1:\d+/", chain["eod-console"].text())[0]
            page = urllib.request.urlopen(url, timeout=10).read().decode()
            step = urllib.request.urlopen(url + "step.txt", timeout=10).read().decode()
            self.assertIn("No exercise runs", step)
            streams = re.findall(r'<img src="/(\w+\.mjpeg)"', page)
            self.assertEqual(streams, ["chosen.mjpeg", "beside.mjpeg"])
            for name in streams:
                with urllib.request.urlopen(url + name, timeout=20) as stream:
                    for jpeg in pictures(stream, 10):
                        self.assertEqual((jpeg[:2], jpeg[-2:]), (b"\xff\xd8", b"\xff\xd9"))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
