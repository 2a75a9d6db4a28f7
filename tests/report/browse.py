"""Uses a report in headless Chromium as a person does, and prints what is seen: browse.py REPORT.html WORK

The page can load nothing from elsewhere. The errors of its console come last. WORK gets screenshots, light and dark."""
import json
import pathlib
import sys

from browser import Browser

INK = """(selector => { const canvas = document.querySelector(selector), data = canvas.getContext('2d')
  .getImageData(0, 0, canvas.width, canvas.height).data, colours = new Set();
  for (let i = 0; i < data.length; i += 4) if (data[i + 3]) colours.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
  return colours.size; })"""


def see(name, value):
    print(f"{name}: {json.dumps(value, ensure_ascii=False)}", flush=True)


def text(browser, selector):
    return browser.ask(f"document.querySelector({json.dumps(selector)})?.textContent")


def count(browser, selector):
    return browser.ask(f"document.querySelectorAll({json.dumps(selector)}).length")


def use_plots(browser):
    axis = "[...document.querySelectorAll('#parallelism .u-over')].length"
    see("plots", browser.ask(axis))
    see("plot drawn", browser.ask(INK + "('#parallelism .uplot canvas')") > 2)
    browser.hover("#parallelism .u-over")
    see("hover", text(browser, "#parallelism .u-legend .u-series:nth-child(2) .u-value"))
    before = browser.ask("document.querySelector('#parallelism .uplot canvas').toDataURL()")
    browser.click("#parallelism .tools button")
    see("zoom changes the plot", before != browser.ask("document.querySelector('#parallelism .uplot canvas').toDataURL()"))
    browser.click("#parallelism .tools button:nth-child(3)")


def use_code(browser):
    if not count(browser, "#lines-generated-code"):
        return see("code", text(browser, "#code .empty"))
    weighed = browser.ask("[...document.querySelectorAll('#lines-source .line')].findIndex(e => e.querySelector('.weight[style]')) + 1")
    if weighed:
        browser.click(f"#lines-source .line:nth-child({weighed}) .line-number")
        see("source to code", text(browser, "#code .status"))
        marked = browser.ask("[...document.querySelectorAll('#lines-generated-code .line')].findIndex(e => e.matches('.marked')) + 1")
        if marked:
            browser.click(f"#lines-generated-code .line:nth-child({marked}) .line-number")
            see("code to source", text(browser, "#code .status"))
            see("marked in the source", count(browser, "#lines-source .marked"))
    browser.keys("Home", "ArrowDown")
    see("line by key", text(browser, "#lines-generated-code .current .line-number"))


def use_graph(browser):
    canvas = "#graph canvas"
    drawn = f"Number(document.querySelector('{canvas}').dataset.%s)"
    see("lanes closed", browser.ask(drawn % "lanes"))
    see("nodes closed", browser.ask(drawn % "nodes"))
    see("graph drawn", browser.ask(INK + f"('{canvas}')") > 3)
    browser.click(canvas, 60, 40)
    see("clicked", text(browser, "#graph-status"))
    browser.keys("Enter")
    see("closed by Enter", text(browser, "#graph-status"))
    browser.ask(f"document.querySelector('{canvas}').focus()")
    browser.keys("Home")
    for _ in range(8):  # until a group has no groups
        browser.keys("ArrowDown")
        if "closed" in text(browser, "#graph-status"):
            browser.keys("Enter")
    browser.keys("n")
    browser.keys("+")
    see("selected", text(browser, "#graph .details code"))
    see("nodes open", browser.ask(drawn % "nodes"))
    before = browser.ask(f"document.querySelector('{canvas}').toDataURL()")
    browser.wheel(canvas, -240)
    see("wheel changes the graph", before != browser.ask(f"document.querySelector('{canvas}').toDataURL()"))
    browser.click("#graph .details .link[title^='%']")
    see("neighbour", text(browser, "#graph .details code"))
    browser.ask(f"document.querySelector('{canvas}').focus()")
    browser.keys("0")


def use_timetable(browser):
    see("bars", browser.ask("Number(document.querySelector('#timetable canvas').dataset.bars)"))
    browser.click("#timetable canvas", 160, 38)
    see("task", text(browser, "#timetable-status"))
    see("task in the graph", text(browser, "#graph .details code"))


def use_keys(browser):
    """By Tab alone to every control that is in sight, each with a name and a mark of focus."""
    browser.ask("scrollTo(0, 0); document.activeElement.blur(); 1")
    wanted = browser.ask("window.controls = new Set([...document.querySelectorAll('button, a[href], select, input, summary, [tabindex]')]"
                         ".filter(e => e.checkVisibility({visibilityProperty: true}))); controls.size")
    browser.ask("window.unseen = new Set(controls); window.faults = []; 1")
    for _ in range(min(wanted + 30, 250)):
        browser.keys("Tab")
        browser.ask("(e => { unseen.delete(e); if (e !== document.body && !(e.textContent.trim() || e.getAttribute('aria-label') || e.labels?.length)) "
                    "faults.push('no name: ' + e.outerHTML.slice(0, 80)); if (e !== document.body && getComputedStyle(e).outlineStyle === 'none') "
                    "faults.push('no focus: ' + e.outerHTML.slice(0, 80)); })(document.activeElement); 1")
    see("not reached by Tab", browser.ask("[...unseen].map(e => e.outerHTML.slice(0, 90))") if wanted < 220 else [])
    see("controls without a name or a mark of focus", browser.ask("[...new Set(faults)]"))
    see("tables without a caption", browser.ask("[...document.querySelectorAll('table:not(.u-legend)')].filter(e => !e.caption).length"))


def main():
    report, work = map(pathlib.Path, sys.argv[1:3])
    work.mkdir(parents=True, exist_ok=True)
    browser = Browser(work / "profile")
    seconds = browser.open(report)
    if "--time" in sys.argv:
        print(f"opened in {seconds:.2f} s")
    see("sections", browser.ask("[...document.querySelectorAll('main > section > h2')].map(e => e.textContent)"))
    use_plots(browser)
    use_code(browser)
    use_graph(browser)
    use_timetable(browser)
    use_keys(browser)
    for name in ["light", "dark"]:
        browser.dark(name == "dark")
        see(f"paper when {name}", browser.ask("getComputedStyle(document.body).backgroundColor"))
        browser.ask("document.querySelector('#graph').scrollIntoView(); 1")
        browser.settle()
        browser.screenshot(work / f"{name}.png")
    see("guards", text(browser, "#guards p"))
    see("verdict", text(browser, "#verification p"))
    see("printed", browser.pdf()[:5].decode())
    print(f"{len(browser.errors)} errors", *browser.errors, sep="\n")
    browser.close()


main()
