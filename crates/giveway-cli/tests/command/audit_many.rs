//! `giveway audit`: many plans at once, and reports.

use std::fs;

use serde_json::{Value, json};

use crate::audit::{fits, folder};
use crate::run::{Folder, WAREHOUSE, WAREHOUSE_PLAN};

#[test]
fn a_batch_goes_on_after_a_file_that_is_wrong() {
    let folder = folder();
    fs::write(folder.path("noise.txt"), "good morning").unwrap();
    let line = "audit warehouse.json noise.txt warehouse.plan.json gone.json --jsonl";
    let run = folder.run(line);
    assert_eq!(run.exit, Some(1));
    let lines: Vec<Value> = run
        .out
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(lines.len(), 3);
    assert_eq!(lines[0]["file"], "noise.txt");
    assert!(lines[0]["error"].as_str().unwrap().contains("line 1"));
    assert_eq!(lines[1]["status"], "optimal");
    fits("auditResult", &lines[1]);
    assert!(
        lines[2]["error"]
            .as_str()
            .unwrap()
            .contains("no file of this name")
    );
    // Without them all is well, and a plan that is illegal is not.
    let good = folder.run("audit warehouse.json warehouse.plan.json --jsonl");
    assert_eq!((good.exit, good.out.lines().count()), (Some(0), 1));
    let bad = folder.run("audit two.json crash.json --jsonl");
    assert_eq!((bad.exit, bad.out.lines().count()), (Some(1), 1));
}

#[test]
fn each_plan_of_a_batch_has_its_own_scene() {
    let folder = folder();
    fs::copy(
        folder.path("warehouse.plan.json"),
        folder.path("warehouse-1.json"),
    )
    .unwrap();
    fs::copy(folder.path("crash.json"), folder.path("two-1.json")).unwrap();
    let run = folder.run("audit two.json warehouse.json warehouse-1.json two-1.json --jsonl");
    let status = |line: &str| {
        let line: Value = serde_json::from_str(line).unwrap();
        (line["name"].clone(), line["status"].clone())
    };
    let found: Vec<_> = run.out.lines().map(status).collect();
    assert_eq!(
        found,
        [
            (json!("warehouse"), json!("optimal")),
            (json!("two"), json!("illegal"))
        ]
    );
}

#[test]
fn a_report_needs_nothing_else() {
    let folder = folder();
    fs::rename(folder.path("crash.json"), folder.path("a<b>&.json")).unwrap();
    for name in ["r.html", "r.md", "r.json"] {
        let run = folder.run(&format!("audit two.json a<b>&.json --report {name}"));
        assert_eq!((run.exit, run.err.as_str()), (Some(1), ""));
    }
    let html = folder.read("r.html");
    for part in [
        "<!doctype html>",
        "a&lt;b&gt;&amp;.json",
        "<svg",
        "class=\"broken\"",
        "prefers-color-scheme: dark",
        "giveway audit two.json",
        "vertex",
    ] {
        assert!(html.contains(part), "{part}");
    }
    assert!(!html.contains("<script") && !html.contains("http"));
    assert!(!html.contains("a<b>"));
    let markdown = folder.read("r.md");
    assert!(markdown.contains("# a\\<b\\>&.json"), "{markdown}");
    assert!(markdown.contains("| sum of costs | 9 |"), "{markdown}");
    assert!(
        markdown.contains("giveway audit two.json 'a<b>&.json'"),
        "{markdown}"
    );
    let json: Value = serde_json::from_str(&folder.read("r.json")).unwrap();
    fits("auditResult", &json);
    assert_eq!(json["status"], "illegal");
    assert_eq!(json.get("link"), None);
}

#[test]
fn the_map_of_a_report_has_chargers_and_the_slow_zone_with_their_legend() {
    let folder = Folder::with(&[("s.json", WAREHOUSE), ("p.json", WAREHOUSE_PLAN)]);
    let run = folder.run("audit s.json p.json --report r.html");
    assert_eq!((run.exit, run.err.as_str()), (Some(0), ""));
    let html = folder.read("r.html");
    assert_eq!(html.matches("class=\"charger\"").count(), 2);
    // Both rows of the slow zone: six cells each.
    assert!(
        html.contains("<path class=\"slow\" d=\"M2 0h6v1h-6z\"/>"),
        "{html}"
    );
    assert!(html.contains("Yellow with a bolt: chargers. Hatched: the slow zone."));
    assert!(!html.contains("Red: where"), "no rule is broken");
    let plain = self::folder();
    let run = plain.run("audit two.json crash.json --report r.html");
    assert_eq!(run.exit, Some(1));
    let html = plain.read("r.html");
    assert!(!html.contains("class=\"charger\"") && !html.contains("Yellow"));
    assert!(html.contains("Red: where a rule is broken."));
}

#[test]
fn a_report_links_to_the_page_at_an_address() {
    let folder = folder();
    for name in ["r.html", "r.md", "r.json"] {
        let run = folder.run(&format!(
            "audit two.json crash.json --report {name} --address https://example.org/giveway/"
        ));
        assert_eq!((run.exit, run.err.as_str()), (Some(1), ""));
    }
    let json: Value = serde_json::from_str(&folder.read("r.json")).unwrap();
    fits("auditResult", &json);
    let link = json["link"].as_str().unwrap();
    let begin = "https://example.org/giveway/#giveway=1&check=";
    assert!(link.starts_with(begin), "{link}");
    assert!(
        link.contains("&name=two&") && link.contains("&audit="),
        "{link}"
    );
    let html = folder.read("r.html");
    let escaped = link.replace('&', "&amp;");
    let open = format!("<a href=\"{escaped}\">Open it in Giveway</a>");
    assert!(html.contains(&open), "{html}");
    let markdown = folder.read("r.md");
    let open = format!("[Open it in Giveway](<{link}>)");
    assert!(markdown.contains(&open), "{markdown}");

    let run = folder.run("audit two.json crash.json --report r.md --address example.org");
    assert_eq!(run.exit, Some(2));
    let told = "expected an address such as https://example.org/giveway/";
    assert!(run.err.contains(told), "{}", run.err);
}
