#!/usr/bin/python3
"""Takes a picture of the page after three seconds of cloth: page.py build/web/page PICTURE.png
Needs Chromium, its driver and selenium, which ./setup.sh --web installs."""
import pathlib
import sys
import time

from selenium import webdriver

if len(sys.argv) != 3:
    sys.exit(__doc__)
options = webdriver.ChromeOptions()
options.binary_location = '/usr/bin/chromium'
for flag in ('headless=new', 'no-sandbox', 'use-gl=angle', 'use-angle=swiftshader', 'enable-unsafe-swiftshader'):
    options.add_argument('--' + flag)
browser = webdriver.Chrome(service=webdriver.chrome.service.Service('/usr/bin/chromedriver'), options=options)
try:
    browser.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                            {'width': 1280, 'height': 720, 'deviceScaleFactor': 1, 'mobile': False})
    browser.get((pathlib.Path(sys.argv[1]) / 'index.html').resolve().as_uri())
    browser.find_element('css selector', '#size [value="5280"]').click()
    while int(browser.execute_script('return document.body.dataset.frame || 0')) < 180:
        time.sleep(0.01)
    # Cloth that stands still is drawn in the best quality.
    browser.execute_script('Object.defineProperty(document, "hidden", { value: true });'
                           'document.dispatchEvent(new Event("visibilitychange"))')
    while browser.execute_script('const { width, clientWidth } = document.getElementById("stage"); return width < 2 * clientWidth'):
        time.sleep(0.1)
    time.sleep(1)
    browser.save_screenshot(sys.argv[2])
finally:
    browser.quit()
