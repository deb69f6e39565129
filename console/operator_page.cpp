#include "console/operator_page.h"

#include <fmt/format.h>

namespace eod::console {

Shown ShownFor(int camera_select) {
  switch (camera_select) {
    case 0:
      return {"quad", ""};
    case 2:
      return {"gripper", "mast"};
    case 3:
      return {"mast", "drive"};
    case 4:
      return {"rear", "drive"};
    default:
      return {"drive", "mast"};
  }
}

std::string StepText(bool is_running, int step, int steps, std::string_view text) {
  if (!is_running) return "No exercise runs: choose the module on the box (key 8), then start (9).";
  return fmt::format("Step {} of {}: {}", step + 1, steps, text);
}

std::string OperatorPage() {
  return R"(<!doctype html>
<html lang="en"><head><title>EOD robot: cameras</title>
<style>
body { margin: 0; background: #111; color: #bbb; font: 15px sans-serif }
main { display: flex; flex-wrap: wrap; justify-content: center; gap: 8px; padding: 8px }
img { width: 640px; height: 480px; background: #000 }
h1 { font-size: 20px; text-align: center; margin: 8px; min-height: 1.2em }
figure { margin: 0 } a { color: #9cf; margin-right: 1em } footer { text-align: center }
</style></head><body>
<h1 id="step"></h1>
<main>
<figure><img src="/chosen.mjpeg" alt="no picture yet"><figcaption>The camera chosen on the box (key c)</figcaption></figure>
<figure id="beside"><img src="/beside.mjpeg" alt="no picture yet"><figcaption>Beside it</figcaption></figure>
</main>
<footer><a href="/drive.mjpeg">drive</a><a href="/mast.mjpeg">mast</a><a href="/gripper.mjpeg">gripper</a>
<a href="/rear.mjpeg">rear</a><a href="/quad.mjpeg">quad</a> A camera sends while it is chosen, or stands beside the chosen one.</footer>
<script>
setInterval(async () => {
  try {
    const step = await fetch("/step.txt");
    if (step.ok) document.getElementById("step").textContent = await step.text();
    const beside = await fetch("/beside.txt");
    if (beside.ok) document.getElementById("beside").hidden = await beside.text() == "";
  } catch (gone) {
    document.getElementById("step").textContent = "eod-console has ended.";
  }
}, 500);
</script>
</body></html>
)";
}

}  // namespace eod::console
