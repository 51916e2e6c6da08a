#!/usr/bin/env python3
"""A sweep on a Slurm of one machine that this test starts: a task is killed, one is stopped, one is put back in the
queue, and one value cannot be kept. Nothing is lost. The scripts are those of the page.   slurm.py PROGRAM FOLDER README"""
import csv
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import time

program, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
failures = 0
RUNS, BROKEN = 40, 10

# A sheet in gusts. Two balls that close in on it make it impossible not to cross; the other bodies are far away.
SCENE = '''
[garment.grid]
columns = 25
rows = 25
width = 0.3
height = 0.3
top = [0.0, 0.15, 0.0]
[pins]
at = "top-edge"
[wind]
gust_amplitude = 0.5
'''
STUDY = '''
scene = "scene.toml"
frames = 1200
[axes]
bodies = [
  [{ shape = "sphere", centre = [0.0, 0.0, -0.12], radius = 0.08, shift = { velocity = [0.0, 0.0, 0.2] } },
   { shape = "sphere", centre = [0.0, 0.0, 0.12], radius = 0.08, shift = { velocity = [0.0, 0.0, -0.2] } }],
  [],
  [{ shape = "sphere", centre = [0.0, 0.0, -2.0], radius = 0.1 }],
  [{ shape = "sphere", centre = [0.0, 0.0, 2.0], radius = 0.1 }]]
"wind.speed" = [2, 3, 4, 5, 6, 7, 8, 9, 10, 11]
'''
CONFIGURATION = '''ClusterName=taut
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
SlurmctldPort=36817
SlurmdPort=36818
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/run/slurmctld.pid
SlurmdPidFile={folder}/run/slurmd.pid
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdLogFile={folder}/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
MailProg=/bin/true
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
'''


def expect(is_so, otherwise):
    global failures
    if not is_so:
        failures += 1
        print(otherwise, flush=True)


def run(*command, code=0):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    expect(done.returncode == code, '%s ended with %d, expected %d: %s' %
           (' '.join(command), done.returncode, code, done.stdout + done.stderr))
    return done.stdout + done.stderr


def sweep(*arguments, code=0):
    return run(program, 'sweep', *arguments, code=code)


def wait_until(is_so, what, seconds=400):
    for _ in range(5 * seconds):
        if is_so():
            return
        time.sleep(0.2)
    raise RuntimeError('%s did not come in %d s; the queue:\n%s' % (what, seconds, run('squeue')))


def start_slurm():
    """Returns a munged if there was none."""
    for name in ('state', 'spool', 'run', 'log'):
        (folder / name).mkdir()
    (folder / 'slurm.conf').write_text(CONFIGURATION.format(host=socket.gethostname().split('.')[0], folder=folder))
    (folder / 'taut').symlink_to(program)
    os.environ['PATH'] = '%s:%s' % (folder, os.environ['PATH'])
    os.environ['SLURM_CONF'] = str(folder / 'slurm.conf')
    munged = None
    if subprocess.run(['munge', '-n'], capture_output=True).returncode != 0:
        run('install', '-d', '-o', 'munge', '-g', 'munge', '-m', '0755', '/run/munge')
        munged = subprocess.Popen(['runuser', '-u', 'munge', '--', 'munged', '--foreground'],
                                  stderr=subprocess.DEVNULL, start_new_session=True)
        wait_until(lambda: subprocess.run(['munge', '-n'], capture_output=True).returncode == 0, 'munged', 20)
    run('slurmctld')
    run('slurmd')
    wait_until(lambda: 'idle' in run('sinfo', '--noheader', '--format=%t'), 'the node', 60)
    return munged


def ended(pid):
    """Zombies have ended too: nobody may be there to be told."""
    try:
        return pathlib.Path('/proc/%d/stat' % pid).read_text().rsplit(')', 1)[1].split()[0] == 'Z'
    except FileNotFoundError:
        return True


def stop_slurm(munged):
    subprocess.run(['scancel', '--state=RUNNING'], capture_output=True)
    subprocess.run(['scancel', '--state=PENDING'], capture_output=True)
    for name in ('slurmd', 'slurmctld'):
        file = folder / 'run' / (name + '.pid')
        if file.exists():
            pid = int(file.read_text())
            os.kill(pid, signal.SIGTERM)
            wait_until(lambda: ended(pid), 'the end of ' + name, 30)
    if munged is not None:
        os.killpg(munged.pid, signal.SIGTERM)
        munged.wait(timeout=20)


def script(language):
    return re.search('```%s\n(#!.*?)```' % language, pathlib.Path(sys.argv[3]).read_text(), re.DOTALL).group(1)


def submit():
    """The array, and the job after it that makes the table. Returns the number of the array."""
    done = subprocess.run(['bash', 'submit.sh'], cwd=folder / 'farm', capture_output=True, text=True)
    expect(done.returncode == 0, done.stdout + done.stderr)
    return done.stdout.split()[-1]


def is_idle():
    return run('squeue', '--noheader') == ''


def table(name):
    with open(folder / name / 'table.csv', newline='') as file:
        return list(csv.DictReader(file))


def file_of(index, ending):
    return folder / 'farm' / 'runs' / ('%06d%s' % (index, ending))


def process_of(index):
    found = [file.parent.name for file in pathlib.Path('/proc').glob('[0-9]*/cmdline')
             if file.read_bytes().split(b'\0')[1:] == [b'sweep', b'run', b'.', b'--index', b'%d' % index, b'']]
    return int(found[0])


def is_under_way(index):
    return file_of(index, '.checkpoint').exists()


def disturb(job):
    """Runs that can keep their bounds begin with 10. Which of them is where when is Slurm's choice."""
    wait_until(lambda: is_under_way(10), 'run 10')
    run('scancel', '%s_10' % job)
    wait_until(lambda: is_under_way(12), 'run 12')
    os.kill(process_of(12), signal.SIGKILL)
    wait_until(lambda: is_under_way(14), 'run 14')
    run('scontrol', 'requeue', '%s_14' % job)
    # Else it would wait for two minutes.
    time.sleep(3)
    run('scontrol', 'update', 'JobId=%s_14' % job, 'StartTime=now')


def test():
    (folder / 'scene.toml').write_text(SCENE)
    (folder / 'study.toml').write_text(STUDY)
    for name in ('farm', 'alone'):
        sweep('plan', 'study.toml', '-o', name)
    (folder / 'farm/task.sh').write_text(script('bash').replace('--mem=2G', '--mem=100M'))
    (folder / 'farm/submit.sh').write_text(script('sh'))
    disturb(submit())
    wait_until(is_idle, 'the end of the queue')
    expect(file_of(10, '.checkpoint').exists(), 'the run that was stopped is not saved')
    missing = sweep('status', 'farm', '--missing').strip()
    expect(missing == '10,12', 'expected that the stopped and the killed run are missing, found ' + missing)
    ends = [row['end'] for row in table('farm')]
    expect(len(ends) == RUNS and ends.count('missing') == 2 and ends.count('broken') == BROKEN,
           'the table of the dependent job says %s' % ends)

    submit()
    wait_until(is_idle, 'the end of the queue')
    expect(sweep('status', 'farm', '--missing') == '\n', 'something is still missing')
    expect(not list((folder / 'farm').rglob('*.checkpoint')), 'a checkpoint is left')

    sweep('run', 'alone', '--all', '--jobs', '2', code=3)
    sweep('merge', 'alone')
    of_farm, alone = ([(row['index'], row['end'], row['reason'], row['state_hash'], row['frames'], row['max_stretch'])
                       for row in table(name)] for name in ('farm', 'alone'))
    expect(of_farm == alone, 'the farm made something else:\n%s\n%s' % (of_farm, alone))
    expect([row[1] for row in alone] == ['broken'] * BROKEN + ['done'] * (RUNS - BROKEN), 'ends: %s' % alone)


if os.geteuid() != 0 or not all(map(shutil.which, ('munged', 'slurmctld', 'slurmd', 'sbatch'))):
    print('SKIPPED: this starts Slurm (setup.sh --farms) as root')
    sys.exit(77)
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # whatever happens, Slurm is stopped
daemon = None
try:
    daemon = start_slurm()
    test()
finally:
    stop_slurm(daemon)
sys.exit(1 if failures else 0)
