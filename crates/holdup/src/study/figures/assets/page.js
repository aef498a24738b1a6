// Draws each figure when it comes near the screen; until then, and in print, the page shows it as SVG.
"use strict";
(() => {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const drawn = new Set();

  function colours(layout) {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(name).trim();
    const themed = {
      paper_bgcolor: colour("--paper"),
      plot_bgcolor: colour("--paper"),
      "font.color": colour("--text"),
      "font.family": getComputedStyle(document.body).fontFamily,
      "hoverlabel.bgcolor": colour("--raised"),
      "hoverlabel.bordercolor": colour("--frame"),
      "hoverlabel.font.color": colour("--text"),
      "modebar.bgcolor": "rgba(0,0,0,0)",
      "modebar.color": colour("--soft"),
      "modebar.activecolor": colour("--text"),
    };
    for (const axis of Object.keys(layout).filter((key) => /^[xy]axis\d*$/.test(key))) {
      themed[axis + ".gridcolor"] = colour("--grid");
      themed[axis + ".linecolor"] = colour("--frame");
      themed[axis + ".tickcolor"] = colour("--frame");
    }
    return themed;
  }

  // The legend needs more room where the page is narrow.
  function height(figure, width) {
    const names = figure.data.filter((trace) => trace.showlegend).map((trace) => trace.name.length);
    let rows = 1;
    let used = 0;
    for (const length of names) {
      const entry = 60 + 7 * length;
      if (used > 0 && used + entry > width - 90) {
        rows += 1;
        used = 0;
      }
      used += entry;
    }
    return figure.layout.height + 20 * (rows - 1);
  }

  function draw(box) {
    const figure = JSON.parse(box.querySelector("script").textContent);
    const plot = box.querySelector(".plot");
    box.classList.add("live");
    const width = plot.clientWidth;
    figure.layout.height = height(figure, width);
    if (width < 500) {
      // Fingers scroll the page, they do not zoom the plot.
      figure.layout.dragmode = false;
      figure.layout.margin = { ...figure.layout.margin, l: 50, r: 8 };
    }
    const config = {
      responsive: true,
      displaylogo: false,
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
      toImageButtonOptions: { format: "svg", filename: "figure" },
    };
    Plotly.newPlot(plot, figure.data, figure.layout, config)
      .then(() => Plotly.relayout(plot, colours(figure.layout)))
      .then(() => drawn.add([plot, figure.layout]));
  }

  const near = new IntersectionObserver(
    (entries) => {
      for (const entry of entries.filter((one) => one.isIntersecting)) {
        near.unobserve(entry.target);
        draw(entry.target);
      }
    },
    { rootMargin: "600px" },
  );
  document.querySelectorAll("figure").forEach((box) => near.observe(box));
  dark.addEventListener("change", () => {
    for (const [plot, layout] of drawn) Plotly.relayout(plot, colours(layout));
  });
})();
