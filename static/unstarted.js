// Says why the page does not start, where no module can be loaded: from a file on disk, inside a
// page that takes its origin away (`sandbox` without `allow-same-origin`), in a browser without
// modules. A classic script, since exactly those browsers refuse the others.

(function () {
  "use strict";

  /** How long modules may take once everything else is there. */
  var PATIENCE_MS = 2000;
  var IS_DISK = location.protocol === "file:";
  var SENTENCES = {
    en: {
      disk: "The playground cannot start from a file on disk: browsers run its programs only from a web address.",
      sandbox: "The page around this one does not let the playground start: it shows it without an origin (sandbox).",
      other: "This browser does not load the programs of the playground. Try a current browser.",
      open: "Open the playground",
      alone: "Open it by itself",
      serve: "How to put this folder on a web address",
    },
    de: {
      disk: "Der Spielplatz kann nicht aus einer Datei auf der Festplatte starten: Browser führen seine Programme nur von einer Webadresse aus.",
      sandbox: "Die Seite ringsum lässt den Spielplatz nicht starten: Sie zeigt ihn ohne Herkunft (sandbox).",
      other: "Dieser Browser lädt die Programme des Spielplatzes nicht. Ein aktueller Browser kann es.",
      open: "Spielplatz öffnen",
      alone: "Für sich allein öffnen",
      serve: "Wie dieser Ordner eine Webadresse bekommt",
    },
  };

  function link(say) {
    var canonical = document.querySelector("link[rel=canonical]");
    var element = document.createElement("a");
    if (IS_DISK) {
      element.href = canonical ? canonical.href + location.hash : "https://developer.mozilla.org/docs/Learn_web_development/Howto/Tools_and_setup/set_up_a_local_testing_server";
      element.textContent = canonical ? say.open : say.serve;
    } else {
      element.href = location.href.replace(/([?&])embed(&|(?=#)|$)/, function (whole, before, after) { return after === "&" ? before : ""; });
      // A sandbox may open no window: the address is to be read.
      element.textContent = say.alone + ": " + element.href.split("#")[0];
      element.target = "_blank";
      element.rel = "noopener";
    }
    return element;
  }

  function tell() {
    var note = document.getElementById("boot-note");
    if (!note || window.givewayStarts) {
      return;
    }
    clearTimeout(timer);
    var asked = /[?&]lang=([a-z]+)/.exec(location.search);
    var say = SENTENCES[(asked ? asked[1] : navigator.language || "").slice(0, 2)] || SENTENCES.en;
    var isSandboxed = !IS_DISK && window.origin === "null";
    note.textContent = (IS_DISK ? say.disk : isSandboxed ? say.sandbox : say.other) + " ";
    note.classList.add("failed");
    note.appendChild(link(say));
  }

  var timer;
  addEventListener("error", function (event) {
    if (event.target && event.target.tagName === "SCRIPT") {
      tell();
    }
  }, true);
  addEventListener("load", function () {
    timer = setTimeout(tell, PATIENCE_MS);
  });
})();
