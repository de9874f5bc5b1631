// A button that copies each piece of code, tables that scroll by themselves, tabs on the page of the languages.
addEventListener("DOMContentLoaded", () => {
  const code = (block) => [...block.querySelectorAll("div.line")].map((line) => line.innerText.replace(/^\s*\d+\s/, (number) =>
    line.querySelector(".lineno") ? "" : number)).join("\n") || block.innerText;
  for (const block of document.querySelectorAll(".contents div.fragment, .contents pre.fragment")) {
    const around = document.createElement("div"), button = document.createElement("button");
    around.className = "copied";
    button.className = "copy";
    button.textContent = "copy";
    button.onclick = async () => {
      await navigator.clipboard.writeText(code(block));
      button.textContent = "copied";
      setTimeout(() => (button.textContent = "copy"), 1500);
    };
    block.replaceWith(around);
    around.append(block, button);
  }
  for (const table of document.querySelectorAll("table.markdownTable, table.doxtable, table.memberdecls, table.fieldtable")) {
    const around = document.createElement("div");
    around.className = "scrolls";
    table.replaceWith(around);
    around.append(table);
  }
  const parts = location.pathname.endsWith("page_languages.html") ? [...document.querySelectorAll(".textblock h1, .textblock h2")] : [];
  if (parts.length) {
    const bar = document.createElement("div");
    bar.className = "tabs_of_languages";
    const shown = parts.map((heading) => heading.nextElementSibling);
    parts.forEach((heading, chosen) => {
      const tab = document.createElement("button");
      tab.textContent = heading.textContent.trim();
      tab.onclick = () => {
        shown.forEach((each, at) => (each.style.display = at === chosen ? "block" : "none"));
        [...bar.children].forEach((each, at) => (each.className = at === chosen ? "chosen" : ""));
      };
      heading.style.display = "none";
      bar.append(tab);
    });
    shown[0].before(bar);
    bar.firstChild.click();
  }
});
