//! A report as HTML: the part that a page shows and prints, and a page of its own.

mod robots;
mod tables;

use std::fmt::Write as _;

use giveway_model::tr;

use super::{Proved, Question, Report, Sign};
use crate::xml::Escaped;

/// A link of so many letters is short enough to be typed.
const TYPED: usize = 120;

/// How the report looks, on a screen and on paper.
const STYLE: &str = include_str!("../report.css");

impl Report {
    /// The report as a page of HTML that needs nothing else, in a language: `en`.
    pub fn page(&self, language: &str) -> String {
        format!(
            "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body class=\"report-page\">\n{}</body>\n</html>\n",
            Escaped(language),
            Escaped(&tr!("{title}: report of a plan", title = self.title)),
            self.html()
        )
    }

    /// The report as a part of a page of HTML; names in it cannot be markup.
    pub fn html(&self) -> String {
        let mut html = String::from("<article class=\"report\">\n");
        self.head(&mut html);
        self.costs_table(&mut html);
        self.changes_table(&mut html);
        self.who_is_last(&mut html);
        self.robots_table(&mut html);
        self.batteries_table(&mut html);
        self.busiest_table(&mut html);
        self.questions(&mut html);
        self.link(&mut html);
        html + "</article>\n"
    }

    fn head(&self, html: &mut String) {
        let _ = write!(html, "<header><div><h1>{}</h1>", Escaped(&self.title));
        for fact in &self.facts {
            let _ = write!(html, "<p>{}</p>", Escaped(fact));
        }
        let known = &self.known;
        html.push_str("</div><div class=\"made\"><p class=\"brand\">Giveway</p>");
        if let Some(date) = &known.date {
            let _ = write!(html, "<p>{}</p>", Escaped(date));
        }
        html.push_str("</div></header>\n");
        let class = match known.proved {
            Proved::OfAll | Proved::OfThese => "claim proved",
            Proved::No | Proved::Bounded => "claim",
        };
        let _ = write!(
            html,
            "<section class=\"{class}\"><p><b>{}</b></p><p>{}",
            Escaped(&known.claim),
            Escaped(&self.costs_told)
        );
        for sentence in self.objective.iter().chain(&known.remarks) {
            let _ = write!(html, " {}", Escaped(sentence));
        }
        let _ = write!(html, "</p></section>\n<figure>{}<figcaption>", self.map);
        for sign in &self.signs {
            let _ = write!(
                html,
                "<span><i class=\"sign-{}\"></i>{}</span>",
                sign.class(),
                Escaped(sign.told())
            );
        }
        let _ = writeln!(
            html,
            "</figcaption><p class=\"note\">{}</p></figure>",
            Escaped(&self.conventions.join(" "))
        );
    }

    fn who_is_last(&self, html: &mut String) {
        if self.last.is_empty() {
            return;
        }
        heading(html, tr!("Who is last, and why"));
        html.push_str("<ul class=\"report-last\">");
        for sentence in &self.last {
            let _ = write!(html, "<li>{}</li>", Escaped(sentence));
        }
        html.push_str("</ul>\n");
    }

    /// The address that opens the plan: as text where it is short enough to be typed from paper.
    fn link(&self, html: &mut String) {
        if let Some(link) = &self.known.link {
            let text = if link.chars().count() <= TYPED {
                link
            } else {
                tr!("open it")
            };
            let (link, text) = (Escaped(link), Escaped(text));
            let _ = writeln!(
                html,
                "<p class=\"report-link\">{} <a href=\"{link}\">{text}</a></p>",
                Escaped(tr!("This plan on the page:"))
            );
        }
    }

    fn questions(&self, html: &mut String) {
        if self.known.questions.is_empty() {
            return;
        }
        heading(html, tr!("Questions"));
        html.push_str("<ol>");
        for Question {
            asked,
            about,
            verdict,
            reasons,
        } in &self.known.questions
        {
            let _ = write!(
                html,
                "<li><p><b>{}</b> {}</p>",
                Escaped(asked),
                Escaped(verdict)
            );
            if let Some(about) = about {
                let _ = write!(html, "<p class=\"note\">{}</p>", Escaped(about));
            }
            if !reasons.is_empty() {
                let _ = write!(html, "<p>{}</p>", Escaped(&reasons.join(" ")));
            }
            html.push_str("</li>");
        }
        html.push_str("</ol>\n");
    }
}

fn heading(html: &mut String, text: &str) {
    let _ = writeln!(html, "<h2>{}</h2>", Escaped(text));
}

impl Sign {
    /// What it means.
    fn told(self) -> &'static str {
        match self {
            Self::Start => tr!("starts here"),
            Self::Goal => tr!("its goal"),
            Self::Busy => tr!("busy cell, by its letter"),
            Self::Breakdown => tr!("breaks down here"),
            Self::Obstacle => tr!("obstacle"),
            Self::Slow => tr!("slow zone"),
            Self::Charger => tr!("charger"),
        }
    }

    const fn class(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Goal => "goal",
            Self::Busy => "busy",
            Self::Breakdown => "breakdown",
            Self::Obstacle => "obstacle",
            Self::Slow => "slow",
            Self::Charger => "charger",
        }
    }
}
