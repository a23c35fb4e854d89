//! Which functions come later: those of the modules that a file lists, and what nothing else
//! calls.

use std::collections::{BTreeMap, BTreeSet};

use walrus::ir::{self, Visitor};
use walrus::{
    ElementItems, ExportItem, FunctionId, FunctionKind, GlobalId, LocalFunction, MemoryId, Module,
    TableId,
};

/// What stands before the name of a function.
const FUNCTION: &str = "= ";

/// What comes later: what is in these paths of Rust, such as `giveway_page::fleet` or
/// `giveway_model::plan::Plan`, or is compiled for it alone; and these functions.
pub(crate) struct Listed {
    paths: BTreeSet<String>,
    functions: BTreeSet<String>,
}

impl Listed {
    /// Reads a path a line, or after `= ` the name of a function; `#` begins a remark.
    pub(crate) fn read(text: &str) -> Self {
        let lines = text
            .lines()
            .filter(|line| !line.starts_with('#') && !line.is_empty());
        let (functions, paths): (Vec<_>, Vec<_>) =
            lines.partition(|line| line.starts_with(FUNCTION));
        let functions = functions
            .iter()
            .filter_map(|line| line.strip_prefix(FUNCTION));
        Self {
            functions: functions.map(str::to_owned).collect(),
            paths: paths.into_iter().map(str::to_owned).collect(),
        }
    }

    /// Whether a function of this name comes later.
    fn has(&self, name: &str) -> bool {
        self.functions.contains(name) || paths(name).any(|path| self.has_path(path))
    }

    /// Whether a path is listed, or one that it is in.
    fn has_path(&self, path: &str) -> bool {
        let ends = path.match_indices("::").map(|(at, _)| at).skip(1);
        self.paths.contains(path)
            || ends
                .into_iter()
                .any(|end| self.paths.contains(&path[..end]))
    }
}

/// The paths of this project's crates in the name of a function.
fn paths(name: &str) -> impl Iterator<Item = &str> {
    const OURS: &str = "giveway_";
    let is_part = |character: char| character.is_alphanumeric() || character == '_';
    name.match_indices(OURS).filter_map(move |(at, _)| {
        if name[..at].ends_with(is_part) {
            return None;
        }
        let path = &name[at..];
        let end = path.find(|character| !is_part(character) && character != ':');
        Some(path[..end.unwrap_or(path.len())].trim_end_matches(':'))
    })
}

/// What a function uses.
#[derive(Default)]
pub(crate) struct Uses {
    pub(crate) functions: BTreeSet<FunctionId>,
    pub(crate) globals: BTreeSet<GlobalId>,
    pub(crate) memories: BTreeSet<MemoryId>,
    pub(crate) tables: BTreeSet<TableId>,
}

impl<'i> Visitor<'i> for Uses {
    fn visit_function_id(&mut self, function: &FunctionId) {
        self.functions.insert(*function);
    }

    fn visit_global_id(&mut self, global: &GlobalId) {
        self.globals.insert(*global);
    }

    fn visit_memory_id(&mut self, memory: &MemoryId) {
        self.memories.insert(*memory);
    }

    fn visit_table_id(&mut self, table: &TableId) {
        self.tables.insert(*table);
    }
}

/// Adds what a function uses.
pub(crate) fn add_uses(uses: &mut Uses, function: &LocalFunction) {
    ir::dfs_in_order(uses, function, function.entry_block());
}

/// The functions that are used otherwise than by a call in another: exported ones, and those that
/// stand in tables.
pub(crate) fn pointed_at(module: &Module) -> BTreeSet<FunctionId> {
    let exported = module
        .exports
        .iter()
        .filter_map(|export| match export.item {
            ExportItem::Function(function) => Some(function),
            _ => None,
        });
    let in_tables = module
        .elements
        .iter()
        .flat_map(|element| match &element.items {
            ElementItems::Functions(functions) => functions.clone(),
            ElementItems::Expressions(_, expressions) => expressions
                .iter()
                .filter_map(|expression| match expression {
                    walrus::ConstExpr::RefFunc(function) => Some(*function),
                    _ => None,
                })
                .collect(),
        });
    exported.chain(in_tables).chain(module.start).collect()
}

/// The functions that come later.
pub(crate) fn later(module: &Module, listed: &Listed) -> BTreeSet<FunctionId> {
    let name = |id: FunctionId| {
        let name = module.funcs.get(id).name.as_deref().unwrap_or_default();
        without_hashes(name)
    };
    let is_listed: BTreeMap<FunctionId, bool> = module
        .funcs
        .iter_local()
        .map(|(id, _)| (id, listed.has(&name(id))))
        .collect();
    let mut first = BTreeSet::new();
    let mut open: Vec<FunctionId> = pointed_at(module).into_iter().collect();
    while let Some(id) = open.pop() {
        if is_listed.get(&id) == Some(&true) || !first.insert(id) {
            continue;
        }
        if let FunctionKind::Local(function) = &module.funcs.get(id).kind {
            let mut uses = Uses::default();
            add_uses(&mut uses, function);
            open.extend(uses.functions);
        }
    }
    is_listed
        .into_keys()
        .filter(|id| !first.contains(id))
        .collect()
}

/// A name without the hashes of crates: `giveway_page[0f3a]::reduce` as `giveway_page::reduce`.
pub(crate) fn without_hashes(name: &str) -> String {
    let mut parts = name.split('[');
    let mut found = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(']') {
            Some((hash, rest))
                if hash.bytes().all(|byte| byte.is_ascii_hexdigit()) && !hash.is_empty() =>
            {
                found.push_str(rest);
            }
            _ => {
                found.push('[');
                found.push_str(part);
            }
        }
    }
    found
}
