// Draws each figure when it comes near the screen; until then, and in print, the page shows it as SVG.
"use strict";
(() => {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const drawn = new Map();

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
    const layout = figure.layout;
    // A plane with equal units becomes empty when it is much taller than wide.
    const plane = layout.yaxis.scaleanchor ? Math.max(0, layout.height - width - 40) : 0;
    return layout.height - plane + 20 * (rows - 1);
  }

  function draw(box) {
    const figure = JSON.parse(box.querySelector("script").textContent);
    const plot = box.querySelector(".plot");
    box.classList.add("live");
    const width = plot.clientWidth;
    if (width < 500) {
      // Fingers scroll the page, they do not zoom the plot.
      figure.layout.dragmode = false;
      figure.layout.margin = { ...figure.layout.margin, l: 50, r: 8 };
    }
    const config = {
      displaylogo: false,
      displayModeBar: width < 500 ? false : "hover",
      modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
      toImageButtonOptions: { format: "svg", filename: "figure" },
    };
    Plotly.newPlot(plot, figure.data, { ...figure.layout, ...size(figure, width) }, config).then(async () => {
      await Plotly.relayout(plot, colours(figure.layout));
      await placeLegend(plot);
      drawn.set(plot, figure);
      resized.observe(plot);
    });
  }

  function size(figure, width) {
    return { width, height: height(figure, width) };
  }

  // The legend stands a fixed distance below the axis; plotly.js wants a fraction of the height that is left,
  // which the legend itself makes smaller: the second pass is right.
  async function placeLegend(plot) {
    for (let pass = 0; pass < 2; pass += 1) {
      await Plotly.relayout(plot, { "legend.y": -52 / plot._fullLayout._size.h });
    }
  }

  const resized = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      const width = target.clientWidth;
      if (width > 0 && width !== target._fullLayout.width) {
        Plotly.relayout(target, size(drawn.get(target), width)).then(() => placeLegend(target));
      }
    }
  });

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
    for (const [plot, figure] of drawn) Plotly.relayout(plot, colours(figure.layout));
  });
})();
