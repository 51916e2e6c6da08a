"""Drives the page in Chromium by its slider, its buttons and the mouse.

usage: test_page.py TAUT FOLDER    FOLDER is build/web, as the target `web` makes it. Pictures go to FOLDER/pictures.
Ends with 77 where Chromium, its driver, selenium or the page is not there.
"""
import functools
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time

TAUT, FOLDER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SCENES = {'hang': 'tshirt-gravity', 'walk': 'tshirt-walk', 'flag': 'flag', 'line': 'washing-line'}
SHIRT_WIND = ['wind.direction=[0.3, 0.0, 1.0]', 'wind.gust_amplitude=0.5', 'wind.gust_period=2', 'wind.gust_turn=0.2']


def skip(reason):
    print('skipped:', reason)
    sys.exit(77)


try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    skip('there is no selenium; ./setup.sh --web installs it')
if not shutil.which('chromium') or not shutil.which('chromedriver'):
    skip('there is no Chromium; ./setup.sh --web installs it')
if not (FOLDER / 'page' / 'page.js').exists():
    skip(f'{FOLDER}/page is not there; `cmake --workflow --preset web` makes it')


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def serve():
    handler = functools.partial(Quiet, directory=FOLDER / 'page')
    server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f'http://127.0.0.1:{server.server_port}/'


def chromium():
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which('chromium')
    for flag in ['headless=new', 'no-sandbox', 'use-gl=angle', 'use-angle=swiftshader', 'enable-unsafe-swiftshader',
                 'disable-quic', 'no-first-run', 'disable-background-networking', 'disable-component-update',
                 'disable-sync', 'window-size=900,620']:
        options.add_argument('--' + flag)
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
    return webdriver.Chrome(service=webdriver.chrome.service.Service(shutil.which('chromedriver')), options=options)


# Every frame's hash: the page itself shows one a second.
WATCH = '''
window.hashes = {};
new MutationObserver(() => { hashes[document.body.dataset.frame] = document.body.dataset.hash; })
  .observe(document.body, { attributes: true });
'''


# Texts wider than their place, and those that stand out of the screen or the panel's first sight of it.
CUT = '''
const isWide = (e) => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== 'inline';
const shown = [...document.querySelectorAll('h1, p, b, button, code, label, output, select, span')]
  .filter((e) => e.checkVisibility() && !e.closest('details'));
const panel = document.getElementById('panel').getBoundingClientRect();
const isHidden = (e) => e.getBoundingClientRect().bottom > Math.min(panel.bottom, innerHeight);
const isOutside = (e) => e.getBoundingClientRect().right > innerWidth || e.getBoundingClientRect().left < 0;
return [...shown.filter((e) => isWide(e) || isOutside(e)),
        ...['wind', 'stretch', 'crossings', 'hash', 'verdict'].map((id) => document.getElementById(id)).filter(isHidden)]
  .map((e) => e.id || e.textContent);
'''
# The lines of the headline, as left, top, width and height.
HEADLINE = '''
return [...document.querySelectorAll('header > *')].filter((e) => e.checkVisibility()).flatMap((e) => {
  const range = document.createRange();
  range.selectNodeContents(e);
  return [...range.getClientRects()].map((r) => [r.left, r.top, r.width, r.height].map(Math.round));
});
'''


class Page:
    def __init__(self, browser):
        self.browser = browser

    def find(self, name):
        return self.browser.find_element(By.ID, name)

    def text(self, name):
        return self.find(name).text

    def data(self):
        return self.browser.execute_script('return {...document.body.dataset}')

    def wait(self, what, holds, seconds=600):  # a machine without a GPU that does other work too
        end = time.monotonic() + seconds
        while not holds():
            assert time.monotonic() < end, f'{what}: not within {seconds} s; {self.data()}; {self.text("notice")}'
            time.sleep(0.05)

    def press(self, group, value):
        self.browser.find_element(By.CSS_SELECTOR, f'#{group} [value="{value}"]').click()

    def set_wind(self, metres_per_second):
        self.find('wind').send_keys(Keys.HOME, *[Keys.PAGE_UP] * (metres_per_second // 2))
        assert self.text('wind-value') == f'{metres_per_second:.1f} m/s', self.text('wind-value')

    def start_over(self):
        # In one task: between two a frame of the cloth before may come.
        self.browser.execute_script('document.getElementById("restart").click();'
                                    'delete document.body.dataset.frame; hashes = {};')

    def run_to(self, frame):
        self.wait(f'frame {frame}', lambda: int(self.data().get('frame', 0)) >= frame)
        return self.browser.execute_script('return hashes')

    def resize(self, width, height):
        self.browser.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
            'width': width, 'height': height, 'deviceScaleFactor': 1, 'mobile': width < 500})

    def picture(self, name):
        folder = FOLDER / 'pictures'
        folder.mkdir(exist_ok=True)
        self.browser.save_screenshot(str(folder / f'{name}.png'))


def program_hashes(scene, size, wind, frames):
    with tempfile.TemporaryDirectory() as folder:
        stats = pathlib.Path(folder) / 'stats.jsonl'
        settings = [f'garment.file=tshirt_{size}', *SHIRT_WIND] if size else []
        sets = [part for setting in [*settings, f'wind.speed={wind}'] for part in ('--set', setting)]
        subprocess.run([TAUT, 'simulate', SCENES[scene], *sets, '--frames', str(frames), '--stats', stats], check=True,
                       stdout=subprocess.DEVNULL)
        rows = [json.loads(line) for line in stats.read_text().splitlines()]
        return {str(row['frame']): row['state_hash'] for row in rows if 'frame' in row}


def test_bits(page, scene, size, wind, frames):
    """The same bits as the program's, and the page says so."""
    expected = program_hashes(scene, size, wind, max(frames))
    page.set_wind(wind)
    page.start_over()
    found = page.run_to(max(frames))
    for frame in map(str, frames):
        assert found[frame] == expected[frame], (scene, size, wind, frame, found[frame], expected[frame])
    if max(frames) >= 60:
        assert page.text('verdict') == '✓ The same bits as on our machine', page.text('verdict')
    assert page.text('crossings') == '0'
    print(f'{scene} {size} wind {wind}: frames {frames} equal, {float(page.data()["ms"]):.1f} ms a frame')
    return expected


def test_hand(page, expected):
    """Pulled by the mouse, the cloth keeps both promises and no longer has the program's bits."""
    stage = page.find('stage')
    page.run_to(30)
    pull = ActionChains(page.browser, duration=30).move_to_element_with_offset(stage, -172, -10).click_and_hold()
    for _ in range(8):
        pull.move_by_offset(-12, 4)
    pull.perform()
    page.wait('the hand', lambda: 'holding' in stage.get_attribute('class'), 60)
    frame = int(page.data()['frame'])
    found = page.run_to(frame + 40)
    page.picture('hand')
    assert page.text('crossings') == '0'
    stretch, bound = (float(part.split()[0]) for part in page.text('stretch').split(' of '))
    assert 0.1 < stretch <= bound == 1.0, page.text('stretch')
    assert found[str(frame + 30)] != expected[str(frame + 30)], 'the hand has moved nothing'
    ActionChains(page.browser).release().perform()
    page.wait('the words', lambda: page.text('verdict') == 'Steered by you: nothing to compare')


def test_colours(page):
    before = page.find('stage').screenshot_as_png
    assert not page.find('legend').is_displayed()
    page.find('colours').click()
    assert page.text('legend-end') == '1 % bound' and page.find('legend').is_displayed()
    page.run_to(int(page.data()['frame']) + 3)
    page.picture('colours')
    assert page.find('stage').screenshot_as_png != before
    page.find('colours').click()


def blue_pixels(picture, box):
    """How many pixels of a box of a PNG file are of the cloth's colour."""
    left, top, width, height = box
    raw = subprocess.run(['ffmpeg', '-loglevel', 'error', '-i', '-', '-vf', f'crop={width}:{height}:{left}:{top}:exact=1',
                          '-f', 'rawvideo', '-pix_fmt', 'rgb24', '-'], input=picture, capture_output=True, check=True).stdout
    return sum(blue > red + 30 for red, blue in zip(raw[0::3], raw[2::3]))


def test_layout(page):
    """On a desktop and a phone no text is cut, the first screen has the verdict, and cloth never flies behind the headline."""
    for width, height in (1280, 720), (390, 844), (360, 640):
        page.resize(width, height)
        stage = (0, 0, width - 344, height) if width > 760 else (0, 0, width, height // 2)
        page.wait('the cloth', lambda: blue_pixels(page.browser.get_screenshot_as_png(), stage) > 1000)
        assert not (cut := page.browser.execute_script(CUT)), (width, cut)
        lines = page.browser.execute_script(HEADLINE)
        page.browser.execute_script('document.querySelector("header").style.opacity = 0')
        for _ in range(8):
            page.run_to(int(page.data()['frame']) + 10)
            page.picture(f'layout_{width}')
            picture = (FOLDER / 'pictures' / f'layout_{width}.png').read_bytes()
            assert not any(blue_pixels(picture, line) for line in lines), (width, page.data()['frame'])
        page.browser.execute_script('document.querySelector("header").style.opacity = 1')
    page.browser.execute_cdp_cmd('Emulation.clearDeviceMetricsOverride', {})


def main():
    browser = chromium()
    browser.set_script_timeout(600)  # a machine without a GPU may stand still for a minute
    try:
        page = Page(browser)
        began = time.monotonic()
        browser.get(serve())
        browser.execute_script(WATCH)
        page.wait('the first frame', lambda: 'frame' in page.data())
        print(f'first frame after {time.monotonic() - began:.1f} s')
        page.press('size', 1028)
        expected = test_bits(page, 'hang', 1028, 0, [1, 60, 600])
        assert float(page.data()['rate']) > 30, f'drawing slows the cloth down: {page.data()["rate"]} frames a second'
        page.wait('the best picture, at rest', lambda: browser.execute_script(
            'const { width, clientWidth } = document.getElementById("stage"); return width === 2 * clientWidth'))
        memory = page.data()['memory']
        page.start_over()
        test_hand(page, expected)
        test_colours(page)
        test_bits(page, 'hang', 1028, 10, [1, 60, 600])
        page.picture('wind')
        test_layout(page)
        assert page.data()['memory'] == memory, (memory, page.data()['memory'])
        page.press('size', 5280)
        test_bits(page, 'hang', 5280, 10, [1, 60])
        page.press('size', 1028)
        page.press('scene', 'walk')
        test_bits(page, 'walk', 1028, 0, [1, 60, 600])
        page.picture('walk')
        for scene, wind in (('flag', 6), ('line', 3)):
            page.press('scene', scene)
            page.wait('its first frame', lambda: 'frame' in page.data())
            page.start_over()
            found = page.run_to(60)
            assert found['60'] == program_hashes(scene, 0, wind, 60)['60'], scene
            assert page.text('wind-value') == f'{wind:.1f} m/s' and page.text('crossings') == '0'
            page.picture(scene)
        errors = [line for line in browser.get_log('browser') if line['level'] == 'SEVERE']
        assert not errors, errors
    finally:
        browser.quit()


main()
