//! What is solved natively and in Wasm, and what must come of it.

/// An instance, the objective if not its own, and the native answer.
pub(crate) struct Case {
    /// The file in `data/`.
    pub(crate) name: &'static str,
    /// The scene's text.
    pub(crate) scene: &'static str,
    /// The objective, as a list of costs separated by commas.
    pub(crate) objective: Option<&'static str>,
    /// Whether the Pareto front is asked for.
    pub(crate) pareto: bool,
    /// Conflicts after which to give up.
    pub(crate) conflicts: Option<u64>,
    /// The native answer, without its seconds.
    #[cfg_attr(
        not(target_arch = "wasm32"),
        expect(dead_code, reason = "the native tests write it")
    )]
    pub(crate) expected: &'static str,
}

macro_rules! case {
    ($name:literal, $scene:literal, $objective:expr, $pareto:expr, $conflicts:expr) => {
        Case {
            name: concat!($name, ".json"),
            scene: include_str!(concat!("../../../../tests/data/", $scene)),
            objective: $objective,
            pareto: $pareto,
            conflicts: $conflicts,
            expected: include_str!(concat!("../data/", $name, ".json")),
        }
    };
}

/// The worked examples of the literature, graded instances, a front, and an end
/// in midst of the work.
pub(crate) const CASES: &[Case] = &[
    case!("warehouse", "seed/warehouse.json", None, false, None),
    case!(
        "warehouse-charges",
        "seed/warehouse.json",
        Some("charges,makespan"),
        false,
        None
    ),
    case!("scenario-1", "seed/scenario-1.json", None, false, None),
    case!("scenario-6", "seed/scenario-6.json", None, false, None),
    case!("dynamic-3x3", "seed/dynamic-3x3.json", None, false, None),
    case!(
        "front",
        "seed/warehouse.json",
        Some("makespan,charges"),
        true,
        None
    ),
    case!("A05", "mmapf/A05_mm_10x10_o10_a10.json", None, false, None),
    case!("A10", "mmapf/A10_mm_15x15_o15_a16.json", None, false, None),
    case!(
        "B09",
        "mmapf/B09_cl_16x16_e_a30.json",
        Some("sum-of-costs"),
        false,
        None
    ),
    case!(
        "A05-cut-short",
        "mmapf/A05_mm_10x10_o10_a10.json",
        None,
        false,
        Some(100)
    ),
];

/// A plan around which the world changes, and the native answer.
pub(crate) struct Changing {
    /// The file in `data/`.
    pub(crate) name: &'static str,
    /// The scene's text.
    pub(crate) scene: &'static str,
    /// The plan's text.
    pub(crate) plan: &'static str,
    /// The text of what changes.
    pub(crate) changes: &'static str,
    /// The native answer, without its seconds.
    #[cfg_attr(
        not(target_arch = "wasm32"),
        expect(dead_code, reason = "the native tests write it")
    )]
    pub(crate) expected: &'static str,
}

/// The methods by which all go on.
pub(crate) const METHODS: [&str; 3] = ["revise", "tunnel=1", "replan"];

macro_rules! changing {
    ($name:literal, $scene:literal, $plan:literal, $changes:expr) => {
        Changing {
            name: concat!($name, ".json"),
            scene: include_str!(concat!("../../../../tests/data/seed/", $scene, ".json")),
            plan: include_str!(concat!("../../../../tests/data/seed/", $plan, ".json")),
            changes: $changes,
            expected: include_str!(concat!("../data/", $name, ".json")),
        }
    };
}

/// The example of the literature from its beginning, and from its own plan after
/// the first change; robots with batteries that meet an obstacle, another goal,
/// an empty battery and a breakdown.
pub(crate) const CHANGING: &[Changing] = &[
    changing!(
        "change-3x3",
        "dynamic-3x3",
        "dynamic-3x3.plan",
        include_str!("../../../../tests/data/seed/dynamic-3x3.changes.json")
    ),
    changing!(
        "change-3x3-later",
        "dynamic-3x3",
        "dynamic-3x3.plan-t1",
        include_str!("../../../../tests/data/seed/dynamic-3x3.changes.json")
    ),
    changing!(
        "change-warehouse",
        "warehouse",
        "warehouse.plan",
        r#"{ "giveway": 1, "changes": [
            { "at": 5, "change": "add-obstacle", "cell": [4, 0] },
            { "at": 5, "change": "set-goal", "agent": "A2", "cell": [0, 2] },
            { "at": 9, "change": "set-battery", "agent": "A2", "level": 10 },
            { "at": 9, "change": "delay-agent", "agent": "A1", "steps": 1 }] }"#
    ),
];
