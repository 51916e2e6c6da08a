// Search that needs no server: search_index.js, loaded by the first word, has the sections of all pages as
// [page, heading, address, text]. An address that ends in ?q=WORDS searches for them.
const folder = new URL('.', document.currentScript.src);
const box = Object.assign(document.createElement('input'), { type: 'search', placeholder: 'Search' });
box.style.cssText = 'font: inherit; width: 11em; padding: .3em .6em; border: 0; border-radius: .3em';
const list = document.createElement('div');
list.style.cssText = 'position: fixed; z-index: 9; top: 2.6rem; right: 0; width: 24rem; max-width: 100%; max-height: 80%; ' +
  'overflow: auto; padding: .6rem; font-size: .7rem; color: #222; background: #fff; box-shadow: 0 2px 12px #0006';
list.hidden = true;

/** Returns the sections that have all words, those first that have them in their headings. */
function find(sections, text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const places = (section) => words.map((word) => [section[1], section[0], section[3]]
    .findIndex((part) => part.toLowerCase().includes(word)));
  return sections.map((section) => ({ section, places: places(section) }))
    .filter(({ places }) => words.length > 0 && !places.includes(-1))
    .sort((a, b) => Math.max(...a.places) - Math.max(...b.places)).slice(0, 25)
    .map(({ section }) => ({ section, at: Math.max(section[3].toLowerCase().indexOf(words[0]) - 40, 0) }));
}

function show() {
  if (!globalThis.tautSections) {
    const script = Object.assign(document.createElement('script'), { src: new URL('search_index.js', folder), onload: show });
    return document.head.append(script);
  }
  const found = find(tautSections, box.value);
  list.hidden = box.value.trim() === '';
  list.replaceChildren(...found.map(({ section: [page, heading, address, text], at }) => {
    const link = Object.assign(document.createElement('a'), { href: new URL(address, folder), textContent: heading,
      style: 'color: #0059a0; font-weight: 600' });
    const line = document.createElement('p');
    line.append(link, heading === page ? '' : `, ${page}`, document.createElement('br'), text.slice(at, at + 110));
    return line;
  }), ...(found.length ? [] : ['Nothing has all of these words.']));
}
box.addEventListener('input', show);
document.querySelector('.md-header__inner').append(box, list);
box.value = new URLSearchParams(location.search).get('q') ?? '';
if (box.value) show();
