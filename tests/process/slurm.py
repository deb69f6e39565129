"""A Slurm cluster of this one machine, on the loopback of the network namespace it is started in."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import time

PROGRAMS = ("munged", "munge", "unmunge", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo",
            "scontrol")

# The daemons run under the one host name that can be looked up without any network. Without
# ProctrackType the default needs cgroups, and jobs report success and do nothing; without
# NoInAddrAny both ports listen on every address.
CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,sched_min_interval=0,bf_interval=1
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus}
PartitionName=main Nodes={host} Default=YES
"""


class Cluster:
    """Runs while the block lasts; `run` calls Slurm's own programs on it."""

    def __init__(self):
        missing = [name for name in PROGRAMS if shutil.which(name) is None]
        if missing:
            raise AssertionError(f"{', '.join(missing)} missing: install the packages of "
                                 "scripts/packages.txt [test]: slurmctld slurmd slurm-client munge")
        self.temporary = tempfile.TemporaryDirectory(prefix="slurm_")
        self.folder = pathlib.Path(self.temporary.name)
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.processes = []

    def run(self, *command, check=True, **options):
        return subprocess.run(command, env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=check, timeout=60, **options).stdout.strip()

    def submit(self, *arguments, **options):
        """Gives the number of the job."""
        return self.run("sbatch", "--parsable", *arguments, **options)

    def wait_for_job(self, job, seconds=200):
        def has_ended():
            queued = self.run("squeue", "-h", "-j", job, check=False)
            return queued == "" or "Invalid job id" in queued
        self.wait_until(has_ended, f"job {job} to end", seconds)

    def wait_until(self, condition, what, seconds=30):
        end = time.monotonic() + seconds
        while not condition():
            for process in self.processes:
                if process.poll() is not None:
                    raise AssertionError(f"{process.args} ended: {self.logs()}")
            if time.monotonic() > end:
                raise AssertionError(f"waited {seconds} s for {what}: {self.logs()}")
            try:
                self.processes[0].wait(0.05)
            except subprocess.TimeoutExpired:
                pass

    def logs(self):
        return "\n".join(f"{log.name}:\n{log.read_text(errors='replace')[-2000:]}"
                         for log in sorted(self.folder.glob("*.log")))

    def start(self, name, *arguments):
        with (self.folder / f"{name}.log").open("w") as log:
            self.processes.append(subprocess.Popen(
                ("unshare", "--uts", "sh", "-c", 'hostname localhost && exec "$@"', "sh",
                 shutil.which(name), *arguments), env=self.environment, stdin=subprocess.DEVNULL,
                stdout=log, stderr=subprocess.STDOUT))

    def give_address(self):
        """Slurm looks names up as getaddrinfo does with AI_ADDRCONFIG: on a machine that has none
        but loopback addresses there are none to be found. One for documentation (RFC 5737)."""
        interfaces = pathlib.Path("/proc/net/dev").read_text().splitlines()[2:]
        if [line.split(":")[0].strip() for line in interfaces] != ["lo"]:
            raise AssertionError("to be run in a network of its own: tests/netns")
        self.run("ip", "address", "replace", "192.0.2.1/32", "dev", "lo")

    def start_munge(self):
        key, at = self.folder / "munge.key", self.folder
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(1024))
        self.start("munged", "-F", f"--key-file={key}", f"--socket={at / 'munge.socket'}",
                   f"--pid-file={at / 'munge.pid'}", f"--seed-file={at / 'munge.seed'}",
                   f"--log-file={at / 'munge.log'}")
        check = f"munge -n -S {at / 'munge.socket'} | unmunge -S {at / 'munge.socket'}"
        self.wait_until(lambda: "Success" in self.run("sh", "-c", check, check=False), "munge")

    def __enter__(self):
        try:
            self.folder.chmod(0o755)
            (self.folder / "state").mkdir()
            (self.folder / "spool").mkdir()
            host = "localhost"
            (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
                host=host, folder=self.folder, cpus=os.cpu_count()))
            self.give_address()
            self.start_munge()
            self.start("slurmctld", "-D")
            self.wait_until(lambda: "is UP" in self.run("scontrol", "ping", check=False),
                            "slurmctld")
            self.start("slurmd", "-D", "-N", host)
            self.wait_until(lambda: self.run("sinfo", "-h", "-o", "%t", check=False) == "idle",
                            "an idle node")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            if process.poll() is None:
                process.terminate()
        for process in self.processes:
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.temporary.cleanup()
