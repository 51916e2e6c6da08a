"""Makes a wheel of libtaut: its Python, the library with all it needs that a Linux of the tag has not, the program that
reads models, and scenes. And an extension for Blender: the add-on with the library.

usage: build.py LIBRARY IMPORTER ADD_ON SOURCES VERSION OUT
"""
import base64
import ctypes
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

# What every Linux has besides glibc (PEP 600).
EVERYWHERE = {'linux-vdso.so.1', 'libc.so.6', 'libm.so.6', 'libstdc++.so.6', 'libgcc_s.so.1', 'libz.so.1',
              'ld-linux-x86-64.so.2'}
ASSETS = ['scenes/tshirt*.toml', 'garments/tshirt_[15]*', 'bodies/mannequin_male_40.glb', 'fabrics/*.toml', 'motions/*.bvh',
          'textures/print.png']
METADATA = '''Metadata-Version: 2.1
Name: taut-cloth
Version: {version}
Summary: Cloth that keeps a bound on its stretch and crosses nothing
Author: The Taut authors
Keywords: cloth, garment, simulation, physics
License: MIT
Classifier: Intended Audience :: Science/Research
Classifier: Operating System :: POSIX :: Linux
Classifier: Programming Language :: Python :: 3
Classifier: Topic :: Scientific/Engineering :: Physics
Classifier: Typing :: Typed
Requires-Python: >=3.9
Provides-Extra: arrays
Requires-Dist: numpy; extra == 'arrays'
Description-Content-Type: text/markdown

'''
WHEEL = 'Wheel-Version: 1.0\nGenerator: taut\nRoot-Is-Purelib: false\nTag: {tag}\n'
# The libstdc++ of GCC 11, which every Linux has whose glibc is 2.34 or newer.
MAX_GLIBCXX = (3, 4, 29)


class Deflate:
    """Packs for every reader of ZIP as zlib does, but a twentieth smaller."""
    library = ctypes.CDLL('libdeflate.so.0')
    library.libdeflate_alloc_compressor.restype = ctypes.c_void_p
    library.libdeflate_deflate_compress.restype = ctypes.c_size_t
    packer = ctypes.c_void_p(library.libdeflate_alloc_compressor(12))

    def __init__(self):
        self.content = bytearray()

    def compress(self, content):
        self.content += content
        return b''

    def flush(self):
        content, packed = bytes(self.content), ctypes.create_string_buffer(len(self.content) + 1024)
        size = self.library.libdeflate_deflate_compress(self.packer, content, ctypes.c_size_t(len(content)), packed,
                                                        ctypes.c_size_t(len(packed)))
        if content and not size:
            raise SystemExit('build.py: libdeflate makes something longer')
        return packed.raw[:size]


zipfile._get_compressor = lambda *_: Deflate()


def needed(file):
    """The libraries of other projects that the program or library loads."""
    lines = subprocess.run(['ldd', file], check=True, capture_output=True, text=True).stdout.splitlines()
    parts = [line.split() for line in lines]
    return {part[0]: part[2] for part in parts if '=>' in part and part[0] not in EVERYWHERE}


def put_binaries(library, importer, package):
    libraries, programs = package / 'lib', package / 'libexec' / 'taut'
    libraries.mkdir(parents=True)
    programs.mkdir(parents=True)
    copies = {libraries / library.name.split('.0.')[0]: library, programs / importer.name: importer}
    for name, file in (needed(library) | needed(importer)).items():
        copies[libraries / name] = file
    for copy, file in copies.items():
        shutil.copy(file, copy)
        subprocess.run(['strip', '--strip-unneeded', copy], check=True)
        place = '$ORIGIN' if copy.parent == libraries else '$ORIGIN/../../lib'
        subprocess.run(['patchelf', '--set-rpath', place, copy], check=True)


def needed_version(files, library):
    """The newest version of a library's symbols that the files ask for, such as (2, 34) of GLIBC."""
    symbols = subprocess.run(['objdump', '-T', *files], check=True, capture_output=True, text=True).stdout
    versions = re.findall(rf'\*UND\*.*\({library}_([0-9.]+)\)', symbols)
    return max(tuple(map(int, version.split('.'))) for version in versions)


def platform_tag(package):
    """The oldest platform that has all symbols the binaries ask for."""
    files = [*(package / 'lib').iterdir(), *(package / 'libexec' / 'taut').iterdir()]
    glibcxx = needed_version(files, 'GLIBCXX')
    if glibcxx > MAX_GLIBCXX:
        raise SystemExit(f'build.py: GLIBCXX {glibcxx} is asked for, newer than {MAX_GLIBCXX}, which the tag promises')
    return 'py3-none-manylinux_%d_%d_x86_64' % needed_version(files, 'GLIBC')[:2]


def put_texts(sources, version, package, info, tag):
    library = sources / 'app' / 'library'
    shutil.copy(library / 'python' / 'taut' / '__init__.py', package / '__init__.py')
    (package / 'py.typed').touch()  # its annotations count (PEP 561)
    for file in (library / 'wheel' / 'taut_cloth').glob('*.py'):
        shutil.copy(file, package / file.name)
    for pattern in ASSETS:
        for file in sorted((sources / 'assets').glob(pattern)):
            to = package / 'share' / 'taut' / file.relative_to(sources / 'assets')
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, to)
    info.mkdir()
    licences = info / 'licenses'
    licences.mkdir()
    shutil.copy(sources / 'LICENSE', licences / 'LICENSE')
    shutil.copy(sources / 'assets' / 'patterns' / 'tshirt' / 'LICENSE', licences / 'LICENSE.garments')
    for name in (file.name for file in (package / 'lib').iterdir() if not file.name.startswith('libtaut')):
        owner = subprocess.run(['dpkg', '-S', f'*/{name}'], check=True, capture_output=True, text=True).stdout
        of_debian = owner.split(':')[0]
        shutil.copy(f'/usr/share/doc/{of_debian}/copyright', licences / f'{of_debian}.copyright')
    (info / 'METADATA').write_text(METADATA.format(version=version) + (library / 'wheel' / 'README.md').read_text())
    (info / 'WHEEL').write_text(WHEEL.format(tag=tag))


def write_wheel(folder, record, wheel):
    lines = []
    with zipfile.ZipFile(wheel, 'w', zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(path for path in folder.rglob('*') if path.is_file()):
            name, content = str(file.relative_to(folder)), file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b'=').decode()
            lines.append(f'{name},sha256={digest},{len(content)}\n')
            entry = zipfile.ZipInfo(name)
            is_program = '/libexec/' in name
            entry.external_attr = (0o100755 if is_program else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
        archive.writestr(record, ''.join(lines) + f'{record},,\n')


def write_extension(package, addon, manifest, extension):
    shutil.copy(addon, extension)
    with zipfile.ZipFile(extension, 'a', zipfile.ZIP_DEFLATED) as archive:
        archive.write(manifest, 'taut_cloth/blender_manifest.toml')
        for file in sorted((package / 'lib').iterdir()):
            archive.write(file, f'taut_cloth/lib/{file.name}')


def main(library, importer, addon, sources, version, out):
    library, importer, sources, out = map(pathlib.Path, (library, importer, sources, out))
    if not shutil.which('patchelf'):
        raise SystemExit("build.py: there is no 'patchelf'; ./setup.sh installs it")
    with tempfile.TemporaryDirectory() as folder:
        package = pathlib.Path(folder) / 'taut_cloth'
        info = f'taut_cloth-{version}.dist-info'
        put_binaries(library, importer, package)
        tag = platform_tag(package)
        put_texts(sources, version, package, pathlib.Path(folder) / info, tag)
        out.mkdir(parents=True, exist_ok=True)
        for older in out.glob('taut_cloth-*.whl'):
            older.unlink()
        wheel = out / f'taut_cloth-{version}-{tag}.whl'
        write_wheel(pathlib.Path(folder), f'{info}/RECORD', wheel)
        extension = out / f'taut_cloth_blender-{version}-linux-x64.zip'
        write_extension(package, addon, sources / 'app' / 'library' / 'blender' / 'blender_manifest.toml', extension)
    for file in (wheel, extension):
        print(f'wrote {file}, {file.stat().st_size / 1e6:.1f} MB')


main(*sys.argv[1:])
