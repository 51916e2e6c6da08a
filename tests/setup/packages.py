"""Asks Debian's package manager: which packages setup.sh brings, and which files those have."""
import os
import re
import subprocess

# Directories that are links into /usr on a merged system, whichever way a package or a program spells them.
MERGED = re.compile(r'^/(bin|sbin|lib|lib32|lib64|libx32)/')
PROGRAM_FOLDERS = ('/usr/bin', '/usr/sbin')


def output_of(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options).stdout


def merged(path):
    return MERGED.sub(r'/usr/\1/', path)


def named_in(setup_sh):
    """The packages of the lists in setup.sh."""
    text = re.sub(r'#.*', '', setup_sh.read_text())
    return [name for array in re.findall(r'^packages\w*=\((.*?)^\)', text, re.S | re.M) for name in array.split()]


class Installed:
    """The installed packages: what each depends on, and what is there before any is asked for."""

    def __init__(self):
        fields = ('Package', 'db:Status-Status', 'Essential', 'Priority', 'Provides', 'Depends', 'Pre-Depends')
        lines = output_of('dpkg-query', '-W', '-f', '\t'.join('${%s}' % field for field in fields) + '\n')
        self.depends, self.providers, self.base = {}, {}, ['apt']
        for line in lines.splitlines():
            name, status, essential, priority, provides, *depends = line.split('\t')
            # A package is configured, and usable, while apt has yet to run its triggers.
            if status not in ('installed', 'triggers-pending', 'triggers-awaited'):
                continue
            self.depends[name] = [alternatives for field in depends for alternatives in field.split(',')]
            if essential == 'yes' or priority == 'required':
                self.base.append(name)
            for provided in [name, *filter(None, provides.split(','))]:
                self.providers.setdefault(bare(provided), []).append(name)

    def brought_by(self, names):
        """`names`, what they depend on and what a bare Debian has. Of alternatives the first that is here."""
        brought, waiting = set(), [*self.base, *names]
        while waiting:
            name = waiting.pop()
            if name in brought or name not in self.depends:
                continue
            brought.add(name)
            for alternatives in self.depends[name]:
                known = (self.providers.get(bare(one)) for one in alternatives.split('|'))
                waiting += next(filter(None, known), [])
        return brought


def bare(dependency):
    """libc6 of 'libc6:any (>= 2.36)'."""
    return re.split(r'[ :(]', dependency.strip())[0]


class Files:
    """The files of some packages."""

    def __init__(self, packages):
        self.known = set(map(merged, output_of('dpkg-query', '-L', *sorted(packages)).split('\n')))

    def have(self, path):
        return merged(path) in self.known or merged(os.path.realpath(path)) in self.known

    def have_program(self, name):
        """By name: a program of that name elsewhere in PATH may stand in for the packaged one."""
        return any(self.have('%s/%s' % (folder, name)) for folder in PROGRAM_FOLDERS)


def owners_of(files_and_programs):
    """Whose package each is of, for people."""
    spellings = {}
    for one in files_and_programs:
        path = one if os.path.isabs(one) else '/usr/bin/' + one
        spellings.update((spelling, one) for spelling in (path, os.path.realpath(path), path.removeprefix('/usr')))
    owners = dict.fromkeys(files_and_programs, 'no package')
    for line in output_of('dpkg-query', '-S', *spellings).splitlines():
        owner, _, path = line.partition(': ')
        if path in spellings and not owner.startswith('diversion '):
            owners[spellings[path]] = 'package ' + owner.split(':')[0]
    return owners
