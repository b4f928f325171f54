# shellcheck shell=bash
# A Slurm cluster of our own on this host: munged, slurmctld and two slurmd, on the loopback interface.

cluster_missing() {
    local program
    for program in munged slurmctld slurmd sbatch; do
        PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || { echo "$program"; return; }
    done
    [[ $(id -u) == 0 ]] || echo 'root'
}

# start_cluster FOLDER FIRST_PORT: for everything in this shell, until stop_cluster.
start_cluster() {
    local port=$2 node
    cluster=$1
    export PATH=$PATH:/usr/sbin SLURM_CONF=$cluster/slurm.conf
    mkdir -p "$cluster"/{munge,state,spool,log}
    chmod 755 "$cluster" "$cluster/munge"
    head -c 1024 /dev/urandom >"$cluster/munge/key"
    chmod 600 "$cluster/munge/key"
    munged --force --socket "$cluster/munge/socket" --key-file "$cluster/munge/key" --pid-file "$cluster/munge/pid" \
        --log-file "$cluster/munge/log" --seed-file "$cluster/munge/seed" 2>>"$cluster/log/start"
    cat >"$SLURM_CONF" <<CONF
ClusterName=quadmesh
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$cluster/munge/socket
CredType=cred/munge
SlurmctldPort=$port
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.%n.pid
SlurmctldLogFile=$cluster/log/slurmctld
SlurmdLogFile=$cluster/log/slurmd.%n
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool/%n
SlurmdParameters=config_overrides
SlurmdTimeout=5
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
NodeName=one NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 RealMemory=4000
NodeName=two NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 RealMemory=4000
PartitionName=all Nodes=one,two Default=YES MaxTime=INFINITE State=UP
CONF
    slurmctld 2>>"$cluster/log/start"
    for node in one two; do
        slurmd -N "$node" 2>>"$cluster/log/start"
    done
}

# The process of a daemon: munge, slurmctld, slurmd.one or slurmd.two.
daemon() {
    if [[ $1 == munge ]]; then cat "$cluster/munge/pid"; else cat "$cluster/$1.pid"; fi
}

stop_cluster() {
    local name
    scancel --quiet --name quadmesh,quadmesh-report 2>/dev/null || true
    for name in slurmd.one slurmd.two slurmctld munge; do
        kill "$(daemon "$name" 2>/dev/null)" 2>/dev/null || true
    done
}
