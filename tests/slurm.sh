#!/usr/bin/env bash
# tests/slurm.sh [RAYTRACER]: a Slurm of two nodes on this machine, in a temporary folder. A picture is rendered by an array of tasks, one node is killed
# in mid-render, and the merged picture must have the bits of a single render. Meanwhile frames are rendered whose first part fails once.
# Exit status 77: it cannot be done here, for the reason that is printed.
set -uo pipefail
cd "$(dirname "$0")/.."
raytracer=$(realpath "${1:-src/RayTracer.Cli/bin/Release/net10.0/raytracer}")
host=$(hostname -s)
user=$(id -un)
B=$(mktemp -d)
export SLURM_CONF=$B/slurm.conf
pids=()
own=()
address=

skip() {
    echo "skipped: $1"
    exit 77
}

fail() {
    echo "FAILED: $1"
    tail -n 15 "$B"/log/*.log "$B"/*.slurm/*.log 2> /dev/null
    exit 1
}

# What was started is stopped by its process ids, jobs before daemons; then nothing of it is left.
finish() {
    local status=$?
    if [ ${#pids[@]} -gt 1 ]; then
        timeout 5 scancel --user "$user" 2> /dev/null
        for ((i = 0; i < 20; i++)); do
            [ -z "$(timeout 5 squeue -h -t R,CG 2> /dev/null)" ] && break
            sleep 0.25
        done
    fi
    for ((i = ${#pids[@]} - 1; i >= 0; i--)); do
        # A namespace does not hand SIGTERM on to what is in it.
        signal=TERM
        [ $i -lt 2 ] || [ ${#own[@]} -eq 0 ] || signal=KILL
        kill -$signal "${pids[i]}" 2> /dev/null
        [ $signal = TERM ] || wait "${pids[i]}" 2> /dev/null
    done
    for ((i = 0; i < 40; i++)); do
        kill -0 "${pids[@]}" 2> /dev/null || break
        sleep 0.25
    done
    [ ${#pids[@]} -eq 0 ] || kill -KILL "${pids[@]}" 2> /dev/null
    [ -z "$address" ] || ip addr del "$address" dev lo
    rm -rf "$B"
    exit $status
}
trap finish EXIT
trap 'exit 130' INT TERM

for program in slurmctld slurmd munged sbatch squeue scancel sinfo; do
    command -v $program > /dev/null || skip "there is no $program (Debian: slurm-wlm and munge)"
done
[ -x "$raytracer" ] || skip "there is no $raytracer: build src/RayTracer.Cli in Release"

# Slurm's controller must find its host under an address that is not the loopback's own.
if [ -z "$(ip -o -4 addr show scope global 2> /dev/null)" ]; then
    ip addr add 10.99.0.1/32 dev lo 2> /dev/null || skip "the loopback is the only network, and it cannot be given another address"
    address=10.99.0.1/32
fi

mkdir -p "$B"/{munge,ctld-state,spool/n1,spool/n2,run,log}
chmod 755 "$B" "$B"/munge
(umask 077 && head -c 128 /dev/urandom > "$B/munge/key")
cat > "$SLURM_CONF" << CONF
ClusterName=testone
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$B/munge/munge.socket,cred_expire=10
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=2,bf_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
StateSaveLocation=$B/ctld-state
SlurmdSpoolDir=$B/spool/%n
SlurmctldPidFile=$B/run/slurmctld.pid
SlurmdPidFile=$B/run/slurmd.%n.pid
SlurmctldLogFile=$B/log/slurmctld.log
SlurmdLogFile=$B/log/slurmd.%n.log
SlurmdParameters=config_overrides
ReturnToService=2
JobRequeue=1
SlurmdTimeout=15
SlurmctldTimeout=10
MessageTimeout=5
TCPTimeout=2
BatchStartTimeout=10
InactiveLimit=0
KillWait=3
MinJobAge=300
Waittime=0
PropagateResourceLimits=NONE
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=16818 CPUs=2 RealMemory=1000 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=16819 CPUs=2 RealMemory=1000 State=UNKNOWN
PartitionName=test Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
CONF

munged -F --key-file="$B/munge/key" --socket="$B/munge/munge.socket" --pid-file="$B/munge/munged.pid" --seed-file="$B/munge/seed" > "$B/log/munged.log" 2>&1 &
pids+=($!)
for ((i = 0; i < 40; i++)); do
    [ -e "$B/munge/munge.socket" ] && break
    sleep 0.1
done
slurmctld -D -i > /dev/null 2>&1 &
pids+=($!)

# With a process namespace of its own, a node is killed with all that runs on it; without, its tasks go on, which the parts must survive too.
own=(unshare -p -f --mount-proc --kill-child=KILL)
"${own[@]}" true 2> /dev/null || own=()
for node in n1 n2; do
    "${own[@]}" slurmd -D -N $node > /dev/null 2>&1 &
    pids+=($!)
done
for ((i = 0; i < 80; i++)); do
    [ "$(timeout 5 sinfo -h -t idle -o %D 2> /dev/null)" = 2 ] && break
    sleep 0.25
done
[ "$(timeout 5 sinfo -h -t idle -o %D 2> /dev/null)" = 2 ] || fail "the two nodes did not come up"
echo "two nodes are up after $SECONDS s"

# Four parts of some seconds each, two on each node.
scene=scenes/cornell.json
options=(--width 256 --height 256 --spp "${RAYTRACER_SLURM_SPP:-256}")
"$raytracer" cluster slurm $scene "${options[@]}" --tasks 4 -o "$B/out.exr" -o "$B/out.rtfilm" --submit --quiet || fail "the jobs could not be submitted"
for ((i = 0; i < 120; i++)); do
    [ "$(squeue -h -t R -w n2 -n render -o %i | wc -l)" -gt 0 ] && break
    sleep 0.25
done
running=$(squeue -h -t R -w n2 -n render -o %i | wc -l)
[ "$running" -gt 0 ] || fail "no task runs on n2"
sleep 2
[ "$(ls "$B"/out.slurm/*-4-*.rtfilm 2> /dev/null | wc -l)" -lt 4 ] || fail "all parts are done already: give RAYTRACER_SLURM_SPP a larger number"
kill -KILL "${pids[3]}"
wait "${pids[3]}" 2> /dev/null
echo "n2 with $running tasks was killed after $SECONDS s"

# Meanwhile: frames, of which the first part fails once. The merge job hands it in again.
cat > "$B/flaky" << FLAKY
#!/bin/bash
if [[ "\$*" == *"--part 1/2"* ]] && mkdir "$B/failed" 2> /dev/null; then
    echo "fails once"
    exit 1
fi
exec $raytracer "\$@"
FLAKY
chmod +x "$B/flaky"
"$raytracer" cluster slurm scenes/animation/01-turn.json --width 32 --height 24 --spp 4 --frames 0..9:3 --tasks 2 --program "$B/flaky" -o "$B/f-##.png" --submit --quiet \
    || fail "the frames could not be submitted"

"$raytracer" render $scene "${options[@]}" --quiet -o "$B/single.rtfilm" || fail "the single render"
for ((i = 0; i < 400; i++)); do
    [ -e "$B/out.exr" ] && grep -q 'are there' "$B"/f-00.slurm/merge.log 2> /dev/null && break
    sleep 0.25
done
[ -e "$B/out.exr" ] || fail "the merged picture did not come"
echo "merged after $SECONDS s"
hash() { "$raytracer" merge "$1" --json | grep filmHash; }
[ "$(hash "$B/out.rtfilm")" = "$(hash "$B/single.rtfilm")" ] || fail "the merged film is another than the single render's"
[ -d "$B/failed" ] && grep -q 'rendered again' "$B/f-00.slurm/merge.log" && grep -q 'are there' "$B/f-00.slurm/merge.log" || fail "the part that failed was not rendered again"
[ "$(cd "$B" && echo f-*.png)" = "f-00.png f-03.png f-06.png f-09.png" ] || fail "frames are missing"
echo "the same bits as a single render; all frames are there; $SECONDS s"
