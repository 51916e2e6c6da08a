#!/usr/bin/env python3
"""Makes an image of the program for containers, of Debian's packages and those that apt_folder.sh made: podman load -i FILE.
    oci_image.py APT_FOLDER FILE.tar"""
import gzip
import hashlib
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile

RELEASE = 'bookworm'
# The image is for running the program alone: it has no manuals and no other languages.
LEFT_OUT = ['/usr/share/doc/*', '/usr/share/info/*', '/usr/share/locale/*', '/usr/share/man/*', '/usr/share/X11/locale/*']
KEPT = ['/usr/share/doc/*/copyright', '/usr/share/X11/locale/C/*', '/usr/share/X11/locale/locale.dir']


def output_of(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


def apt_sources(apt_folder):
    """Sources of this machine's apt for the release, its updates and its security, and the folder."""
    known = output_of('apt-get', 'indextargets', '--format', 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)',
                      'Created-By: Packages', 'Origin: Debian').splitlines()
    of_release = [line for line in known if line.split()[2].startswith(RELEASE)]
    if not of_release:
        sys.exit('oci_image.py: apt knows no mirror of Debian %s' % RELEASE)
    return '\n'.join([*of_release, 'deb [trusted=yes] file:%s ./' % apt_folder]) + '\n'


def make_root(apt_folder, file):
    """A file system with the program, as a tar file."""
    rules = ['--dpkgopt=path-exclude=' + path for path in LEFT_OUT] + ['--dpkgopt=path-include=' + path for path in KEPT]
    subprocess.run(['mmdebstrap', '--quiet', '--variant=essential', '--include=taut,libosmesa6', *rules,
                    '--hook-dir=/usr/share/mmdebstrap/hooks/file-mirror-automount', RELEASE, file, '-'],
                   input=apt_sources(apt_folder), text=True, check=True)


class Blobs:
    """The files of an image, each named after its own hash."""

    def __init__(self, folder):
        self.folder = folder
        (folder / 'blobs/sha256').mkdir(parents=True)

    def add(self, content, kind):
        """Adds bytes or a file and returns what others of the image say of it."""
        if isinstance(content, bytes):
            content = io.BytesIO(content)
        digest = hashlib.file_digest(content, 'sha256').hexdigest()
        content.seek(0)
        with (self.folder / 'blobs/sha256' / digest).open('wb') as file:
            shutil.copyfileobj(content, file)
            size = file.tell()
        return {'mediaType': 'application/vnd.oci.image.%s' % kind, 'digest': 'sha256:' + digest, 'size': size}

    def add_json(self, value, kind):
        return self.add(json.dumps(value).encode(), kind)


def make_layout(folder, root, version, architecture):
    """An image of one layer, as the OCI image specification 1.0 has it."""
    blobs = Blobs(folder)
    packed = root.with_suffix('.tar.gz')
    with root.open('rb') as file:
        diff_id = 'sha256:' + hashlib.file_digest(file, 'sha256').hexdigest()
        file.seek(0)
        with packed.open('wb') as compressed, gzip.GzipFile('', 'wb', fileobj=compressed, mtime=0) as stream:
            shutil.copyfileobj(file, stream)
    with packed.open('rb') as file:
        layer = blobs.add(file, 'layer.v1.tar+gzip')
    config = blobs.add_json({
        'architecture': architecture, 'os': 'linux', 'rootfs': {'type': 'layers', 'diff_ids': [diff_id]},
        'config': {'Entrypoint': ['/usr/bin/taut'], 'Cmd': ['--help'], 'WorkingDir': '/work', 'Env': ['PATH=/usr/bin:/bin']}},
        'config.v1+json')
    manifest = blobs.add_json({'schemaVersion': 2, 'mediaType': 'application/vnd.oci.image.manifest.v1+json',
                               'config': config, 'layers': [layer]}, 'manifest.v1+json')
    manifest['annotations'] = {'org.opencontainers.image.ref.name': 'taut:' + version}
    (folder / 'oci-layout').write_text('{"imageLayoutVersion": "1.0.0"}')
    (folder / 'index.json').write_text(json.dumps({'schemaVersion': 2, 'manifests': [manifest]}))
    return layer['size']


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    apt_folder, image = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    package = next(apt_folder.glob('taut_*.deb'), None)
    if package is None:
        sys.exit('oci_image.py: no taut_*.deb in %s, which app/install/apt_folder.sh makes' % apt_folder)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_root(apt_folder, folder / 'root.tar')
        size = make_layout(folder / 'layout', folder / 'root.tar', output_of('dpkg-deb', '--field', package, 'Version').strip(),
                           output_of('dpkg', '--print-architecture').strip())
        with tarfile.open(image, 'w') as archive:
            for file in ('oci-layout', 'index.json', 'blobs'):
                archive.add(folder / 'layout' / file, file)
    print('wrote %s, %.0f MB' % (image, size / 1e6))


main()
