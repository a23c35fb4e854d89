//! A refusal names what a file seems to be.

use super::refused;

#[test]
fn what_a_text_seems_to_be_is_named() {
    for (text, kind) in [
        ("<!DOCTYPE html>\n<p>map", "a web page (HTML)"),
        ("<svg xmlns=\"\">", "a picture (SVG)"),
        ("p cnf 2 1\n1 2 0\n", "a formula in DIMACS"),
        (
            "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n",
            "the description of a ROS map",
        ),
        ("P2\n2 2\n255\n0 0\n", "PGM"),
        (
            "id,x,y\n1,2,3\n",
            "a table (CSV) with the columns \"id,x,y\"",
        ),
        ("2024-05-01 12:00:01 INFO started\n", "a log"),
        ("import heapq\n", "a program"),
        (
            r#"{ "type": "FeatureCollection", "features": [] }"#,
            "GeoJSON",
        ),
        (
            r#"{ "name": "a", "version": "1", "dependencies": {} }"#,
            "package.json",
        ),
        (r#"{ "nbformat": 4, "cells": [] }"#, "Jupyter"),
        (
            r#"{ "foo": 1, "bar": 2 }"#,
            "JSON of another kind, with the keys foo, bar",
        ),
        ("[1, 2]", "a list in JSON"),
        (r#"{ "Solver": "clingo", "Call": [] }"#, "--outf=2"),
        ("", "an empty file"),
        ("good morning", "\"good morning\""),
    ] {
        let told = refused(text);
        assert!(told.contains(kind), "{told}");
        assert!(told.starts_with("line 1, column 1"), "{told}");
    }
}

#[test]
fn json_of_the_projects_own_keeps_its_faults() {
    assert!(refused(r#"{ "giveway": 1, "mapp": [] }"#).contains("the unknown key \"mapp\""));
    assert!(refused(r#"{ "giveway": 9, "map": [], "agents": [] }"#).contains("version 9"));
    assert!(refused(r#"{ "map": ["."], "agents": [] }"#).contains("giveway"));
}
