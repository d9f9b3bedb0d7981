"""Tests of blackhole explore in Chromium; script/test-explore runs them.

Each check prints one line. The first failure ends the run with exit code 1.
"""

import argparse
import base64
import json
import os
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service


class Failure(Exception):
    pass


def check(what, holds, seen=''):
    if not holds:
        raise Failure(f'{what}: {seen}' if seen != '' else what)
    print(f'ok       {what}', flush=True)


def until(what, action, seconds=60):
    """Check that an action has a true value before long, and return that."""
    value = wait_for(what, action, seconds)
    print(f'ok       {what}', flush=True)
    return value


def wait_for(what, action, seconds=60):
    """The first true value of an action, which is tried until then."""
    end = time.time() + seconds
    while True:
        value = action()
        if value:
            return value
        if time.time() > end:
            raise Failure(f'{what}: not within {seconds} s')
        time.sleep(0.05)


class Program:
    """A running blackhole explore, in a folder of its own."""

    def __init__(self, binary, *arguments, folder=None):
        self.binary = binary
        self.folder = folder or tempfile.mkdtemp(prefix='explore-')
        environment = {k: v for k, v in os.environ.items() if k not in ('DISPLAY', 'WAYLAND_DISPLAY')}
        self.process = subprocess.Popen(
            [binary, 'explore', *arguments], cwd=self.folder, env=environment,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        found = re.search(r'http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/', line)
        if not found:
            raise Failure('the program prints its address: ' + line + self.process.stderr.read())
        self.address, self.port, self.token = found.group(0), int(found.group(1)), found.group(2)

    def run(self, *arguments):
        done = subprocess.run([self.binary, *arguments], cwd=self.folder, capture_output=True, text=True)
        if done.returncode:
            raise Failure(' '.join(arguments) + ': ' + done.stderr)
        return done.stdout

    def read(self, name):
        with open(os.path.join(self.folder, name), 'rb') as file:
            return file.read()

    def memory(self):
        """Resident memory in MB."""
        with open(f'/proc/{self.process.pid}/status') as file:
            return int(re.search(r'VmRSS:\s+(\d+)', file.read()).group(1)) / 1024

    def end(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(10)
        shutil.rmtree(self.folder, ignore_errors=True)


class Page:
    """A browser with the page in it."""

    def __init__(self, address, width=1000, height=620, ratio=1, mobile=False):
        options = Options()
        for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', '--hide-scrollbars', '--disable-dev-shm-usage',
                         f'--window-size={width},{height}'):
            options.add_argument(argument)
        options.set_capability('goog:loggingPrefs', {'browser': 'ALL', 'performance': 'ALL'})
        options.binary_location = shutil.which('chromium')
        self.driver = webdriver.Chrome(service=Service(shutil.which('chromedriver')), options=options)
        self.resize(width, height, ratio, mobile)
        self.driver.get(address)
        wait_for('the page begins', lambda: self.js('return window.explore && explore.steps.length'))

    def resize(self, width, height, ratio=1, mobile=False):
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
            'width': width, 'height': height, 'deviceScaleFactor': ratio, 'mobile': mobile})

    def js(self, code, *arguments):
        return self.driver.execute_script(code, *arguments)

    def value(self, path):
        return self.js('return explore.values[arguments[0]]', path)

    def stats(self):
        return self.js('const { finished, ...rest } = explore.stats; return rest')

    def settled(self, seconds=240):
        """Wait for the final picture of the latest input."""
        def done():
            s = self.stats()
            return s['stage'] == 2 and self.js('return explore.settled()')
        wait_for('the picture is finished', done, seconds)

    def finished(self):
        """The bytes of the final picture."""
        text = self.driver.execute_async_script(
            'const done = arguments[0], reader = new FileReader();'
            'reader.onload = () => done(reader.result.split(",")[1]); reader.readAsDataURL(explore.stats.finished)')
        return base64.b64decode(text)

    def mouse(self, kind, x, y, **more):
        self.driver.execute_cdp_cmd('Input.dispatchMouseEvent', {
            'type': kind, 'x': x, 'y': y, 'button': 'left', 'buttons': 1, 'clickCount': 1, **more})

    def drag(self, x, y, dx, dy, steps=10, **more):
        self.mouse('mousePressed', x, y, **more)
        for k in range(1, steps + 1):
            self.mouse('mouseMoved', x + dx * k / steps, y + dy * k / steps, **more)
            time.sleep(0.016)
        self.mouse('mouseReleased', x + dx, y + dy, **more)

    def click(self, css):
        x, y = self.js(
            'const e = document.querySelector(arguments[0]); e.scrollIntoView({block: "center"});'
            'const b = e.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]', css)
        self.mouse('mousePressed', x, y)
        self.mouse('mouseReleased', x, y)

    def key(self, key, code=None, modifiers=0, text=None):
        code = code or key
        numbers = {'Tab': 9, 'Enter': 13, 'Escape': 27, 'Space': 32, ' ': 32, 'ArrowLeft': 37, 'ArrowUp': 38, 'ArrowRight': 39,
                   'ArrowDown': 40, 'Delete': 46}
        event = {'key': key, 'code': code, 'modifiers': modifiers,
                 'windowsVirtualKeyCode': numbers.get(key, ord(key.upper()) if len(key) == 1 else 0)}
        if text or (len(key) == 1 and not modifiers & 2):
            event['text'] = text or key
        if key == 'Enter':
            event['text'] = '\r'
        self.driver.execute_cdp_cmd('Input.dispatchKeyEvent', {'type': 'keyDown', **event})
        self.driver.execute_cdp_cmd('Input.dispatchKeyEvent', {'type': 'keyUp', **{k: v for k, v in event.items() if k != 'text'}})

    def type(self, text):
        self.driver.execute_cdp_cmd('Input.insertText', {'text': text})

    def preset(self, name):
        """Show a preset, and wait for its settings."""
        self.js('explore.act("preset", [arguments[0]])', name)
        wait_for('a preset', lambda: self.js('return explore.settledScene()'))

    def control(self, path, part='input, select'):
        """Open the group of a setting and focus its control."""
        self.js('choosePanel("settings"); const box = document.querySelector(`#groups [data-path="${arguments[0]}"]`);'
                'box.closest("details").open = true; box.scrollIntoView({block: "center"}); const e = box.querySelector(arguments[1]);'
                'e.focus(); if (e.select) e.select();', path, part)

    def enter(self, path, text, part='input'):
        """Type a value into the control of a setting."""
        self.control(path, part)
        self.type(text)
        self.key('Enter')
        self.js('document.activeElement.blur()')

    def text(self, css):
        return self.js('return document.querySelector(arguments[0]).textContent', css)

    def toasts(self):
        return self.js('return [...document.querySelectorAll("#toasts p")].map(p => p.textContent)')

    def said(self, part):
        return wait_for(f'the page says "{part}"', lambda: next((t for t in self.toasts() if part in t), None))

    def answer(self, name, button='#ask-yes'):
        """Fill in the question for a file's name."""
        wait_for('a question is open', lambda: self.js('return document.getElementById("ask").open'))
        self.js('document.getElementById("ask-name").focus(); document.getElementById("ask-name").select()')
        self.type(name)
        self.click(button)

    def complaints(self):
        return [e['message'] for e in self.driver.get_log('browser') if e['level'] in ('SEVERE', 'WARNING')]

    def close(self):
        self.driver.quit()


def middle(page):
    return page.js('const b = document.getElementById("view").getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]')


# ----------------------------------------------------------------------------------------


def first_look(program, page):
    page.settled()
    width, height = page.stats()['size']
    box = page.js('const b = document.getElementById("frame").getBoundingClientRect(); return [b.width, b.height]')
    check('the picture fills the view', width == round(box[0]) or height == round(box[1]), (width, height, box))
    program.run('render', '--width', str(width), '--height', str(height), '-q', '-o', 'expected.png')
    check('the finished picture has the bytes of render', page.finished() == program.read('expected.png'))
    hosts = page.js('return [...new Set(performance.getEntriesByType("resource").map(e => new URL(e.name).origin))]')
    check('the page asks no other host', hosts == [program.address.split('/' + program.token)[0]], hosts)
    check('the browser has no complaints', page.complaints() == [], page.complaints())


def movement(program, page):
    x, y = middle(page)
    before = page.value('camera.azimuth'), page.value('camera.inclination')
    page.drag(x, y, 120, 40)
    until('a drag orbits', lambda: page.value('camera.azimuth') != before[0] and page.value('camera.inclination') != before[1])
    check('a drag to the right turns the scene to the right', float(page.value('camera.azimuth')) > float(before[0]))
    check('a drag down raises the camera', float(page.value('camera.inclination')) < float(before[1]))
    until('the drag is a step of the history', lambda: page.js('return explore.step') == 1)
    page.key('z', 'KeyZ', 2)
    until('undo brings the camera back', lambda: (page.value('camera.azimuth'), page.value('camera.inclination')) == before)
    page.key('Z', 'KeyZ', 10)
    until('redo moves it again', lambda: page.value('camera.azimuth') != before[0])
    far = float(page.value('camera.distance'))
    page.driver.execute_cdp_cmd('Input.dispatchMouseEvent', {'type': 'mouseWheel', 'x': x, 'y': y, 'deltaX': 0, 'deltaY': -120})
    until('the wheel moves nearer', lambda: float(page.value('camera.distance')) < far)
    near = float(page.value('camera.distance'))
    page.driver.execute_cdp_cmd('Emulation.setTouchEmulationEnabled', {'enabled': True, 'maxTouchPoints': 2})
    touch = lambda kind, gap: page.driver.execute_cdp_cmd('Input.dispatchTouchEvent', {
        'type': kind, 'touchPoints': [] if kind == 'touchEnd' else [{'x': x - gap, 'y': y, 'id': 0}, {'x': x + gap, 'y': y, 'id': 1}]})
    touch('touchStart', 40)
    for gap in range(44, 80, 4):
        touch('touchMove', gap)
        time.sleep(0.02)
    touch('touchEnd', 0)
    page.driver.execute_cdp_cmd('Emulation.setTouchEmulationEnabled', {'enabled': False})
    until('a pinch moves nearer', lambda: float(page.value('camera.distance')) < near)
    page.drag(x, y, 60, 20, modifiers=8)
    until('Shift and drag look around', lambda: page.value('camera.look-at') is not None)
    page.key('h', 'KeyH')
    until('H looks at the hole again', lambda: page.value('camera.look-at') is None)
    azimuth = page.value('camera.azimuth')
    page.key('ArrowLeft')
    until('the arrow keys orbit', lambda: page.value('camera.azimuth') != azimuth)
    roll = page.value('camera.roll')
    page.key('e', 'KeyE')
    until('E rolls', lambda: page.value('camera.roll') != roll)
    fov = float(page.value('camera.fov'))
    page.key('[', 'BracketLeft')
    until('[ narrows the field of view', lambda: float(page.value('camera.fov')) < fov)


def controls(program, page):
    page.preset('default')
    wait_for('a preset', lambda: page.value('camera.distance') == '54')
    page.enter('camera.distance', '30')
    until('a number', lambda: page.value('camera.distance') == '30')
    page.enter('camera.inclination', '500')
    page.said('camera.inclination')
    check('a value out of range is refused', page.value('camera.inclination') == '77', page.value('camera.inclination'))
    page.control('disk.turbulence.strength', 'input[type=range]')
    for _ in range(5):
        page.key('ArrowRight')
    until('a slider by its keys', lambda: float(page.value('disk.turbulence.strength')) > 4.5)
    page.control('output.tone-map', 'select')
    page.js('document.activeElement.value = "agx"; document.activeElement.dispatchEvent(new Event("change", {bubbles: true}))')
    until('a choice', lambda: page.value('output.tone-map') == 'agx')
    page.control('physics.doppler')
    page.key(' ', 'Space')
    until('a switch', lambda: page.value('physics.doppler') == 'off')
    page.enter('sampling.seed', '18446744073709551615')
    until('a seed of 64 bits', lambda: page.value('sampling.seed') == '18446744073709551615')
    page.js('const f = document.querySelectorAll(\'#groups [data-path="camera.position"] input\');'
            '["20", "4", "12"].forEach((v, k) => { f[k].value = v; }); f[2].dispatchEvent(new Event("change", {bubbles: true}))')
    until('a vector', lambda: page.value('camera.position') == '20,4,12')
    page.control('sky.kind', 'select')
    page.js('document.activeElement.value = "grid"; document.activeElement.dispatchEvent(new Event("change", {bubbles: true}))')
    until('a choice or file', lambda: page.value('sky.kind') == 'grid')
    check('a setting without effect says what it needs', 'sky.kind' in page.js('return explore.idle["sky.rotation"]'))
    for outside in ('/etc/hostname', '../secret.png', './link.png'):
        if outside == './link.png':
            os.symlink('/etc/hostname', os.path.join(program.folder, 'link.png'))
        page.js('explore.change("sky.kind", arguments[0])', outside)
        page.said(f"'{outside}' is not in the folder")
    check('files elsewhere are refused', page.value('sky.kind') == 'grid')
    program.run('render', '--sky', 'grid', '--projection', 'equirectangular', '--no-disk', '--width', '64', '-q', '-o', 'map.png')
    page.js('explore.change("sky.kind", "./map.png")')
    until('a file in the folder', lambda: page.value('sky.kind') == './map.png')
    page.settled()
    page.js('choosePanel("presets")')
    count = page.js('return document.querySelectorAll("#presets img").length')
    until('every preset has a picture', lambda: page.js(
        'document.querySelectorAll("#presets img").forEach(i => { i.loading = "eager" });'
        'return [...document.querySelectorAll("#presets img")].every(i => i.complete && i.naturalWidth === 240)') and count >= 10, 300)
    page.click('#presets button[data-name="luminet"]')
    until('a click on a preset shows it', lambda: page.value('disk.colour') == 'bolometric')
    page.js('choosePanel("settings")')
    page.js('const f = document.getElementById("find"); f.value = "roll"; f.dispatchEvent(new Event("input"))')
    check('the search finds settings', page.js('return [...document.querySelectorAll("#groups .setting")].filter(e => e.offsetParent).map(e => e.dataset.path)') == ['camera.roll'])
    page.js('const f = document.getElementById("find"); f.value = ""; f.dispatchEvent(new Event("input"))')


def development(program, page):
    page.preset('default')
    page.settled()
    box = page.js('const b = document.querySelector("#exposure input[type=range]").getBoundingClientRect(); return [b.left, b.top, b.width, b.height]')
    page.mouse('mousePressed', box[0] + box[2] / 2, box[1] + box[3] / 2)
    page.mouse('mouseMoved', box[0] + box[2] * 0.52, box[1] + box[3] / 2)
    page.mouse('mouseReleased', box[0] + box[2] * 0.52, box[1] + box[3] / 2)
    until('the exposure control works', lambda: float(page.value('output.exposure')) > 0)
    before = page.js('return explore.stats.drawn.length')
    wait_for('an exposed picture comes', lambda: page.stats()['input'] >= page.js('return explore.input'))
    first = page.js('return explore.stats.drawn.filter(d => d.input === explore.input)[0]')
    check('another exposure needs no coarse picture', first['stage'] == 1 and first['width'] > 500, first)
    check('the histogram counts', '%' in page.text('#clipped'), page.text('#clipped'))
    page.preset('default')


def inspection(program, page):
    page.preset('default')
    wait_for('the default', lambda: page.value('output.exposure') == '0')
    page.settled()
    x, y = middle(page)
    page.drag(x + 100, y + 20, 0, 0, steps=1)
    until('a click explains a pixel', lambda: page.text('#report').startswith('pixel '))
    place = re.match(r'pixel (\d+,\d+)', page.text('#report')).group(1)
    check('the report is that of --pixel', page.text('#report').strip() == program.run('render', '--pixel', place).strip())
    check('the light path is drawn', page.js('return document.querySelector("#side polyline").points.length') > 50)
    page.preset('kerr')
    wait_for('a rotating hole', lambda: page.value('hole.spin') not in ('0', None))
    page.js('document.getElementById("report").textContent = ""')
    page.key('Enter')
    until('Enter explains the middle', lambda: 'pixel' in page.text('#report'))
    check('its light path is drawn', page.js('return document.querySelector("#side polyline").points.length') > 20)


def take_home(program, page):
    page.preset('luminet')
    wait_for('luminet', lambda: page.value('disk.colour') == 'bolometric')
    page.enter('image.width', '160')
    page.enter('camera.inclination', '70')
    wait_for('its settings', lambda: page.value('image.height') == '90' and page.value('camera.inclination') == '70')
    page.click('#copy')
    command = page.said('blackhole render').split(': ', 1)[1]
    check('the command line is short', command == 'blackhole render --preset luminet --inclination 70 --width 160', command)
    page.click('#render')
    page.answer('view.png')
    page.said('view.png is finished')
    program.run(*command.split()[1:], '-q', '-o', 'line.png')
    check('the rendered file has the bytes of the command line', program.read('view.png') == program.read('line.png'))
    page.click('#save')
    page.answer('mine.yaml')
    page.said('Saved mine.yaml')
    program.run('render', 'mine.yaml', '-q', '-o', 'file.png')
    check('so has the picture of the saved scene', program.read('file.png') == program.read('line.png'))
    page.click('#save')
    page.answer('mine.yaml')
    until('a file is not replaced unasked', lambda: 'exists' in page.text('#ask-problem'))
    old = program.read('mine.yaml')
    page.click('#ask-no')
    page.enter('camera.inclination', '71')
    wait_for('another inclination', lambda: page.value('camera.inclination') == '71')
    page.click('#save')
    page.answer('mine.yaml')
    wait_for('it asks', lambda: page.text('#ask-yes') == 'Replace')
    page.click('#ask-yes')
    until('it is replaced when asked', lambda: program.read('mine.yaml') != old)
    for name in ('../out.yaml', '/tmp/out.yaml', '.hidden.yaml', 'out.txt'):
        page.js('explore.send("save-scene keep " + arguments[0])', name)
    page.said('does not end in')
    check('no name leads out of the folder', not os.path.exists(os.path.join(program.folder, '..', 'out.yaml')) and not os.path.exists('/tmp/out.yaml'))
    os.symlink('/tmp/explore-target.yaml', os.path.join(program.folder, 'link.yaml'))
    page.js('explore.send("save-scene replace link.yaml")')
    page.said('is a link')
    check('no link leads out of it', not os.path.exists('/tmp/explore-target.yaml'))
    page.preset('default')
    wait_for('default', lambda: page.value('disk.colour') == 'black-body')
    page.enter('disk.arms.depth', '0.4')
    until('a setting without an option', lambda: page.value('disk.arms.depth') == '0.4')
    page.click('#copy')
    check('what only a file can hold is said', 'disk.arms.depth' in page.said('Only a scene file'))
    page.enter('image.width', '1600')
    wait_for('a large picture', lambda: page.value('image.width') == '1600')
    page.click('#render')
    page.answer('large.png')
    until('a rendering shows its progress', lambda: page.js('const b = document.getElementById("job-bar"); return !document.getElementById("job").hidden && b.value > 0 && b.value < 1'), 60)
    page.click('#job-cancel')
    page.said('large.png is cancelled')
    check('a cancelled file is not there', sorted(f for f in os.listdir(program.folder) if 'large' in f or '.part' in f) == [])


def animation(program, page):
    page.preset('default')
    page.enter('image.width', '96')
    wait_for('a small animation', lambda: page.value('image.width') == '96')
    page.click('#key-add')
    until('a key is set', lambda: page.js('return explore.keys.length') == 1)
    page.js('const s = document.getElementById("scrub"); s.value = 1000; s.dispatchEvent(new Event("input")); s.dispatchEvent(new Event("change"))')
    page.enter('camera.distance', '30')
    page.enter('camera.azimuth', '130')
    wait_for('another view', lambda: page.value('camera.azimuth') == '130' and page.value('camera.distance') == '30')
    page.js('document.body.focus()')
    page.key('k', 'KeyK')
    until('K sets another', lambda: page.js('return explore.keys.length') == 2)
    until('the animation can play', lambda: not page.js('return document.getElementById("play").disabled'))
    page.js('const s = document.getElementById("scrub"); s.value = 500; s.dispatchEvent(new Event("input")); s.dispatchEvent(new Event("change"))')
    until('scrubbing shows the time between', lambda: page.value('camera.azimuth') == '110' and page.value('camera.distance') == '42')
    page.js('const s = document.getElementById("scrub"); s.value = 0; s.dispatchEvent(new Event("input"))')
    page.js('const d = document.getElementById("duration"); d.value = 2; d.dispatchEvent(new Event("change", {bubbles: true}))')
    page.js('document.querySelector("#keys button:last-child").focus()')
    for _ in range(40):
        page.key('ArrowLeft')
        if page.js('return explore.keys[1].time') <= 2:
            break
    page.key('ArrowLeft')
    until('the arrow keys move a key', lambda: page.js('return explore.keys[1].time') < 2, 10)
    page.click('#play')
    until('the animation plays', lambda: float(page.value('camera.distance')) < 50)
    until('and ends', lambda: page.text('#play') == 'Play')
    page.click('#save-animation')
    page.answer('animation.yaml')
    page.said('Saved animation.yaml')
    check('the animation is sound', 'no problems' in program.run('scene', 'check', 'animation.yaml'))
    program.run('animate', 'animation.yaml', '--frame-range', '0-1', '-q', '-o', 'frames/%03d.png')
    check('and animate renders it', len(program.read('frames/001.png')) > 1000)
    check('it has the keys', 'camera.distance:\n      interpolation: smooth\n      0: 54\n' in program.read('animation.yaml').decode())
    page.js('document.querySelector("#keys button").focus()')
    page.key('Delete')
    until('Delete deletes a key', lambda: page.js('return explore.keys.length') == 1)


def two_pages(program, page):
    page.preset('default')
    other = Page(program.address, 920, 600)
    try:
        other.preset('face-on')
        until('the other page has its own scene', lambda: other.value('camera.inclination') == '12')
        page.settled()
        other.settled()
        check('two pages at once show two scenes', page.value('camera.inclination') == '77' and other.value('camera.inclination') == '12')
    finally:
        other.close()


def interruptions(program, page):
    page.enter('camera.distance', '44')
    wait_for('a scene to keep', lambda: page.value('camera.distance') == '44')
    page.js('explore.socket.close()')
    until('the page notices', lambda: not page.js('return document.getElementById("lost").hidden'))
    until('the page comes back', lambda: page.js('return document.getElementById("lost").hidden && explore.socket.readyState === 1'))
    until('with its scene', lambda: page.value('camera.distance') == '44' and page.js('return explore.settledScene()'))
    page.settled()
    os.kill(program.process.pid, signal.SIGSTOP)
    x, y = middle(page)
    page.drag(x, y, 80, 0)
    time.sleep(3)
    os.kill(program.process.pid, signal.SIGCONT)
    page.settled()
    check('a stalled program catches up', page.value('camera.azimuth') != '90', page.value('camera.azimuth'))
    page.driver.refresh()
    wait_for('a reload', lambda: page.js('return window.explore && explore.steps.length'))
    check('a reload keeps the scene', page.value('camera.distance') == '44')


def request(program, lines, body=b''):
    """The status line that raw bytes get."""
    with socket.create_connection(('127.0.0.1', program.port), 5) as raw:
        raw.sendall('\r\n'.join(lines + ['', '']).encode() + body)
        raw.settimeout(5)
        return raw.recv(4096).split(b'\r\n')[0].decode()


def strangers(program, page):
    host = f'127.0.0.1:{program.port}'
    get = lambda path, *more, host=host: request(program, [f'GET {path} HTTP/1.1', f'Host: {host}', 'Connection: close', *more])
    upgrade = ['Upgrade: websocket', 'Connection: Upgrade', 'Sec-WebSocket-Version: 13', 'Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==']
    talk = lambda token, *more, host=host: request(program, [f'GET /{token}/talk HTTP/1.1', f'Host: {host}', *upgrade, *more])
    origin = f'Origin: http://{host}'
    wrong = program.token[:-1] + ('0' if program.token[-1] != '0' else '1')
    check('the page itself is answered', ' 200 ' in get(f'/{program.token}/'))
    check('a wrong token is not', ' 403 ' in get(f'/{wrong}/') and ' 403 ' in get('/') and ' 403 ' in get(f'/{program.token}'))
    check('a foreign Host is not', ' 403 ' in get(f'/{program.token}/', host=f'evil.example:{program.port}') and ' 403 ' in get(f'/{program.token}/', host='127.0.0.1'))
    check('a foreign Origin is not', ' 403 ' in get(f'/{program.token}/', 'Origin: http://evil.example'))
    check('nothing else is there', ' 404 ' in get(f'/{program.token}/../../etc/passwd') and ' 404 ' in get(f'/{program.token}/preset/..%2f.jpg'))
    check('no other method works', ' 405 ' in request(program, [f'POST /{program.token}/ HTTP/1.1', f'Host: {host}', 'Content-Length: 0', 'Connection: close']))
    check('a page of its own may talk', ' 101 ' in talk(program.token, origin))
    check('one with a wrong token may not', ' 403 ' in talk(wrong, origin))
    check('a hostile page may not', ' 403 ' in talk(program.token, 'Origin: http://evil.example') and ' 403 ' in talk(program.token, 'Origin: null'))
    check('nor one without an origin', ' 403 ' in talk(program.token))
    check('nor one that renames the host', ' 403 ' in talk(program.token, origin, host=f'evil.example:{program.port}'))
    other = [line.split()[3] for line in open('/proc/net/tcp') if line.split()[1].endswith(f':{program.port:04X}') and line.split()[3] == '0A']
    bound = [line.split()[1] for line in open('/proc/net/tcp') if line.split()[1].endswith(f':{program.port:04X}') and line.split()[3] == '0A']
    check('it listens on the loopback interface alone', bound == [f'0100007F:{program.port:04X}'], (bound, other))


def nonsense(program, page, count=1000):
    page.js('''
      const random = n => Math.floor(Math.random() * n);
      const words = ["window", "drawn", "change", "restore", "preset", "orbit", "approach", "look", "roll", "face", "inspect", "command",
        "save-scene", "animation", "save-animation", "scrub", "render", "cancel", "key", "", "keep", "replace"];
      const numbers = ["0", "1", "-1", "1e9", "1e999", "nan", "inf", "0.5", "99999999999999999999", "", "x", "../x.yaml", "-0", "3600"];
      const paths = Object.keys(explore.values).concat(["x.y", "", "camera"]);
      for (let k = 0; k < arguments[0]; k += 1) {
        if (random(10) === 0) { explore.socket.send(crypto.getRandomValues(new Uint8Array(random(300)))); continue; }
        const line = [words[random(words.length)], ...Array.from({length: random(5)}, () => numbers[random(numbers.length)])].join(" ");
        const more = Array.from({length: random(4)}, () => paths[random(paths.length)] + " " + numbers[random(numbers.length)]);
        explore.socket.send([line, ...more].join("\\n"));
      }''', count)
    page.js('explore.resize()')
    page.preset('default')
    wait_for('the default after nonsense', lambda: page.value('camera.distance') == '54')
    page.settled()
    check(f'{count} random messages do no harm', program.process.poll() is None)
    page.js('document.getElementById("toasts").replaceChildren()')


def accessibility(program, page):
    page.js('choosePanel("settings"); document.querySelectorAll("details").forEach(d => { d.open = true })')
    tree = page.driver.execute_cdp_cmd('Accessibility.getFullAXTree', {})['nodes']
    nameless = []
    for node in tree:
        if node.get('ignored'):
            continue
        properties = {p['name']: p['value'].get('value') for p in node.get('properties', [])}
        if properties.get('focusable') and node['role']['value'] not in ('RootWebArea', 'generic') and not node.get('name', {}).get('value'):
            nameless.append(node['role']['value'])
    check('every control has a name', nameless == [], nameless)
    page.js('document.activeElement.blur(); window.scrollTo(0, 0)')
    seen = set()
    for _ in range(400):
        page.key('Tab')
        here = page.js('const e = document.activeElement; return e === document.body ? null : (e.closest("#groups [data-path]")?.dataset.path || e.id || e.textContent)')
        if here is None or (here == 'view' and 'view' in seen and len(seen) > 40):
            break
        seen.add(here)
    wanted = {'undo', 'copy', 'save', 'render', 'help', 'view', 'key-add', 'duration', 'scrub', 'find', 'camera.distance', 'diagnostics.debug-textures'} - {'undo'}
    check('the keyboard reaches everything', wanted <= seen, wanted - seen)
    low = page.js('''
      const light = c => { const v = c.map(x => { x /= 255; return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4 }); return 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2] };
      const parse = s => (s.match(/[\\d.]+/g) || []).map(Number);
      const ground = e => { for (; e; e = e.parentElement) { const c = parse(getComputedStyle(e).backgroundColor); if (c.length === 3 || c[3] > 0.5) return c } return [0, 0, 0] };
      const found = [];
      for (const e of document.querySelectorAll("button, label, p, span, h1, summary, figcaption, small, input, select, output")) {
        if (!e.offsetParent || e.disabled || e.type === "range" || e.type === "checkbox" || e.closest(".idle") || ![...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()) && !e.value) continue;
        const a = light(parse(getComputedStyle(e).color)), b = light(ground(e));
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (ratio < 4.5) found.push([e.id || e.textContent.slice(0, 30), ratio.toFixed(2)]);
      }
      return found''')
    check('text has a contrast of at least 4.5', low == [], low)
    page.resize(1280, 720)
    wait_for('a window', lambda: page.js('return innerWidth') == 1280)
    time.sleep(0.3)
    check('1280 × 720 shows everything without scrolling', page.js('return document.documentElement.scrollHeight <= 720 && document.documentElement.scrollWidth <= 1280'))
    page.resize(390, 844, 2, True)
    wait_for('a phone', lambda: page.js('return innerWidth') == 390)
    time.sleep(0.5)
    check('nothing is wider than a phone', page.js('return document.documentElement.scrollWidth') <= 390, page.js(
        'return [...document.querySelectorAll("body *")].filter(e => e.getBoundingClientRect().right > 391 && e.offsetParent).slice(0, 5).map(e => e.id || e.className || e.tagName)'))
    page.resize(1000, 620)
    wait_for('a window again', lambda: page.js('return innerWidth') == 1000)


def soak(program, page, seconds):
    """Random input; memory must not grow after the first quarter."""
    rng = random.Random(1)
    paths = ['disk.turbulence.strength', 'output.exposure', 'disk.opacity', 'camera.fov', 'hole.spin', 'disk.time', 'disk.arms.depth']
    start = time.time()
    early = late = 0
    while time.time() < start + seconds:
        x, y = middle(page)
        choice = rng.randrange(9)
        if choice < 4:
            page.drag(x + rng.uniform(-200, 200), y + rng.uniform(-80, 80), rng.uniform(-200, 200), rng.uniform(-90, 90), steps=rng.randrange(3, 40), modifiers=rng.choice((0, 0, 0, 8)))
        elif choice == 4:
            for _ in range(rng.randrange(1, 6)):
                page.driver.execute_cdp_cmd('Input.dispatchMouseEvent', {'type': 'mouseWheel', 'x': x, 'y': y, 'deltaX': 0, 'deltaY': rng.choice((-120, 120))})
        elif choice == 5:
            path = rng.choice(paths)
            page.js('const s = document.querySelector(`#groups [data-path="${arguments[0]}"] input[type=range]`); s.value = arguments[1]; s.dispatchEvent(new Event("input"))', path, rng.random())
        elif choice == 6:
            page.js('explore.act("preset", [arguments[0]])', rng.choice(['default', 'edge-on', 'luminet', 'kerr', 'falling', 'lens-only']))
        elif choice == 7:
            page.drag(x + rng.uniform(-200, 200), y + rng.uniform(-80, 80), 0, 0, steps=1)
        else:
            time.sleep(rng.uniform(0, 2))
        now = program.memory()
        if time.time() < start + seconds / 4:
            early = max(early, now)
        elif time.time() > start + seconds * 3 / 4:
            late = max(late, now)
    check(f'{seconds} s of random input', program.process.poll() is None)
    print(f'         memory: at most {early:.0f} MB in the first quarter, {late:.0f} MB in the last', flush=True)
    check('memory is flat', late < 1.25 * early + 40, (early, late))
    page.preset('default')
    page.js('document.getElementById("toasts").replaceChildren()')
    wait_for('the default after the soak', lambda: page.value('camera.distance') == '54')
    page.settled()


def endings(program, page):
    page.close()
    other = Program(program.binary, '--no-open')
    page = Page(other.address)
    page.js('explore.send("render keep large.png")')
    wait_for('a rendering', lambda: page.js('return !document.getElementById("job").hidden && document.getElementById("job-bar").value > 0'))
    other.process.send_signal(signal.SIGINT)
    other.process.wait(5)
    check('Ctrl-C ends it', other.process.returncode == 130, other.process.returncode)
    check('and a rendering leaves nothing behind', os.listdir(other.folder) == [], os.listdir(other.folder))
    page.close()
    other.end()
    taken = subprocess.run([program.binary, 'explore', '--port', str(program.port)], capture_output=True, text=True)
    check('a port in use is said', taken.returncode == 4 and f'port {program.port}' in taken.stderr, taken.stderr)
    until('the last closed page ends it', lambda: program.process.poll() is not None, 60)
    check('with success', program.process.returncode == 0, program.process.returncode)


def bench(binary):
    """Pictures a second and latencies while the camera moves, as the page measures them."""
    program = Program(binary, '--keep')
    # The view of this window is 480 × 270 pixels.
    page = Page(program.address, 840, 500)
    try:
        page.js('for (const e of ["header", "#animation", "#panel"]) document.querySelector(e).style.display = "none";'
                'const f = document.getElementById("frame"); f.style.cssText = "width: 480px; height: 270px"')
        print('a drag of six seconds with sixty inputs a second, view of 480 × 270 pixels')
        print('scene          pictures/s   rays (median)   latency median, 95 %   first sharper picture')
        for preset in ('default', 'luminet', 'edge-on', 'kerr'):
            page.preset(preset)
            time.sleep(1.5)
            page.js('explore.stats.drawn.length = 0; explore.stats.latencies.length = 0')
            x, y = middle(page)
            page.mouse('mousePressed', x, y)
            start = time.time()
            k = 0
            while time.time() < start + 6:
                k += 1
                page.mouse('mouseMoved', x - 150 + (3 * k) % 300, y)
                time.sleep(max(0, start + k / 60 - time.time()))
            page.js('window.released = performance.now()')
            page.mouse('mouseReleased', x, y)
            time.sleep(2)
            stats = page.stats()
            drawn = [d for d in stats['drawn'] if d['stage'] == 0]
            rate = (len(drawn) - 1) / (drawn[-1]['at'] - drawn[0]['at']) * 1000
            sizes = sorted((d['width'] * d['height'], d['width'], d['height']) for d in drawn)
            latencies = sorted(stats['latencies'])
            sharper = [d['at'] for d in stats['drawn'] if d['stage'] >= 1 and d['at'] > drawn[-1]['at']]
            _, w, h = sizes[len(sizes) // 2]
            print(f'{preset:<14} {rate:6.1f}       {w} × {h:<9} {latencies[len(latencies) // 2]:5.0f} ms, {latencies[int(0.95 * len(latencies))]:4.0f} ms'
                  f'        {sharper[0] - drawn[-1]["at"] if sharper else float("nan"):5.0f} ms after the last coarse one', flush=True)
    finally:
        page.close()
        program.end()


def pictures(binary, folder):
    """The pictures of docs/explore.md."""
    os.makedirs(folder, exist_ok=True)
    program = Program(binary, '--keep')
    page = Page(program.address, 1280, 720)
    shot = lambda name, quality=88: open(os.path.join(folder, name), 'wb').write(base64.b64decode(
        page.driver.execute_cdp_cmd('Page.captureScreenshot', {'format': 'jpeg', 'quality': quality})['data']))
    try:
        page.settled()
        page.js('document.querySelectorAll("details").forEach(d => { d.open = d.textContent.startsWith("Camera") })')
        shot('explore.jpg')
        page.js('choosePanel("presets"); document.querySelectorAll("#presets img").forEach(i => { i.loading = "eager" })')
        wait_for('presets', lambda: page.js('return [...document.querySelectorAll("#presets img")].every(i => i.complete && i.naturalWidth === 240)'), 120)
        page.click('#presets button[data-name="kerr"]')
        time.sleep(1)
        page.settled()
        shot('explore-presets.jpg')
        x, y = middle(page)
        page.drag(x - 180, y + 12, 0, 0, steps=1)
        wait_for('a pixel', lambda: page.text('#report').startswith('pixel '))
        time.sleep(0.5)
        shot('explore-pixel.jpg')
        page.preset('default')
        page.js('choosePanel("settings")')
        wait_for('default', lambda: page.value('camera.distance') == '54')
        page.click('#key-add')
        for at, changes in ((400, ('camera.distance 30', 'camera.azimuth 130')), (1000, ('camera.distance 14', 'camera.azimuth 200', 'camera.inclination 84'))):
            page.js('const s = document.getElementById("scrub"); s.value = arguments[0]; s.dispatchEvent(new Event("input")); explore.act("change", [], arguments[1])', at, list(changes))
            wait_for('its scene', lambda: page.value('camera.azimuth') == changes[1].split()[1])
            page.click('#key-add')
        page.js('const s = document.getElementById("scrub"); s.value = 620; s.dispatchEvent(new Event("input"))')
        time.sleep(1)
        page.settled()
        page.js('document.querySelectorAll("details").forEach(d => { d.open = d.textContent.startsWith("Disk") }); document.activeElement.blur()')
        shot('explore-animation.jpg')
        page.preset('default')
        page.resize(390, 844, 2, True)
        time.sleep(1)
        page.settled()
        shot('explore-phone.jpg', 80)
    finally:
        page.close()
        program.end()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('binary')
    parser.add_argument('--soak', type=float)
    parser.add_argument('--bench', action='store_true')
    parser.add_argument('--pictures')
    parser.add_argument('--only')
    given = parser.parse_args()
    binary = os.path.abspath(given.binary)
    if given.bench:
        return bench(binary)
    if given.pictures:
        return pictures(binary, given.pictures)
    program = Program(binary, *(['--keep'] if given.soak or given.only else []))
    page = Page(program.address)
    try:
        if given.soak:
            soak(program, page, given.soak)
        else:
            tests = [first_look, movement, controls, development, inspection, take_home, animation, two_pages, interruptions, strangers, nonsense, accessibility]
            for test in tests:
                if not given.only or given.only == test.__name__:
                    print(f'{test.__name__.replace("_", " ")}:', flush=True)
                    test(program, page)
            if not given.only:
                print('soak:')
                soak(program, page, 30)
                print('endings:')
                endings(program, page)
        print('explore: all checks hold')
    except Failure as failure:
        print(f'FAILED   {failure}', flush=True)
        try:
            page.driver.save_screenshot('/tmp/explore-failure.png')
            print('         toasts: ' + json.dumps(page.toasts(), ensure_ascii=False))
        except Exception:
            pass
        sys.exit(1)
    finally:
        try:
            page.close()
        except Exception:
            pass
        program.end()


main()
