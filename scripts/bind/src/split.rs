//! Splits a program in two parts that share their memory.
//!
//! The first part has, for each function of the later one that it may call, a stub with the
//! same name and type: it has the later part loaded if it is not there, and calls the function
//! through a table that the later part fills. The later part imports from the first what it
//! uses of it.
//!
//! Binaryen's wasm-split does the same; its packages for Node come without that command.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;

use walrus::ir::Value;
use walrus::{
    ConstExpr, ElementItems, ElementKind, ExportItem, FunctionBuilder, FunctionId, FunctionKind,
    GlobalKind, ImportedFunction, LocalFunction, Module, ModuleConfig, RefType, TableId, passes,
};

use crate::choice::{self, Listed, Uses, add_uses, pointed_at};

/// The module from which the later part imports: the first part.
const FIRST: &str = "first";
/// What the first part imports: a function that loads the later one.
const LOAD: (&str, &str) = ("later", "load");
/// The table through which the first part calls functions of the later one.
const TABLE: &str = "later";

/// Both parts as Wasm.
pub(crate) struct Parts {
    pub(crate) first: Vec<u8>,
    pub(crate) later: Vec<u8>,
}

/// Splits bound Wasm that has the names of its functions.
///
/// # Errors
/// Where it is no Wasm, or nothing of it comes later.
pub(crate) fn split(wasm: &[u8], listed: &Listed) -> Result<Parts, Box<dyn Error>> {
    let mut config = ModuleConfig::new();
    config.generate_name_section(false);
    let parse = || config.parse(wasm).map_err(|error| format!("{error:#}"));
    let mut first = parse()?;
    let later = choice::later(&first, listed);
    if later.is_empty() {
        return Err("nothing comes later: has it names?".into());
    }
    let border = Border::of(&first, &later);
    keep_first(&mut first, &later, &border)?;
    // An id is of one module alone; the same bytes give the same choice and the same border.
    let mut second = parse()?;
    let later = choice::later(&second, listed);
    let border = Border::of(&second, &later);
    keep_later(&mut second, &later, &border);
    Ok(Parts {
        first: first.emit_wasm(),
        later: second.emit_wasm(),
    })
}

/// What is used across the border of the two parts.
struct Border {
    /// The functions of the later part that the first may call, in the order of the table.
    entries: Vec<FunctionId>,
    /// What the later part uses of the first.
    shared: Uses,
}

impl Border {
    fn of(module: &Module, later: &BTreeSet<FunctionId>) -> Self {
        let (mut by_first, mut shared) = (Uses::default(), Uses::default());
        for (id, function) in module.funcs.iter_local() {
            let uses = if later.contains(&id) {
                &mut shared
            } else {
                &mut by_first
            };
            add_uses(uses, function);
        }
        by_first.functions.extend(pointed_at(module));
        let entries = later.intersection(&by_first.functions).copied().collect();
        shared.functions.retain(|id| !later.contains(id));
        Self { entries, shared }
    }

    /// The names under which the first part exports what the later one uses, in the order of
    /// functions, globals, memories, tables.
    fn items(&self) -> BTreeMap<String, ExportItem> {
        let functions = self
            .shared
            .functions
            .iter()
            .map(|&id| ExportItem::Function(id));
        let globals = self.shared.globals.iter().map(|&id| ExportItem::Global(id));
        let memories = self
            .shared
            .memories
            .iter()
            .map(|&id| ExportItem::Memory(id));
        let tables = self.shared.tables.iter().map(|&id| ExportItem::Table(id));
        let all = functions.chain(globals).chain(memories).chain(tables);
        all.enumerate()
            .map(|(number, item)| (short(number), item))
            .collect()
    }
}

/// A name that no export of wasm-bindgen has.
fn short(mut number: usize) -> String {
    const DIGITS: &[u8] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    let mut name = String::from("$");
    loop {
        name.push(char::from(DIGITS[number % DIGITS.len()]));
        number /= DIGITS.len();
        if number == 0 {
            return name;
        }
    }
}

fn keep_first(
    module: &mut Module,
    later: &BTreeSet<FunctionId>,
    border: &Border,
) -> Result<(), Box<dyn Error>> {
    let size = u64::try_from(border.entries.len())?;
    let table = module
        .tables
        .add_local(false, size, Some(size), RefType::FUNCREF);
    module.exports.add(TABLE, table);
    for (name, item) in border.items() {
        module.exports.add(&name, item);
    }
    let nothing = module.types.add(&[], &[]);
    let (load, _) = module.add_import_func(LOAD.0, LOAD.1, nothing);
    let ready = ready(module, table, load);
    for (slot, &id) in border.entries.iter().enumerate() {
        let stub = stub(module, id, table, ready, i32::try_from(slot)?);
        module.funcs.get_mut(id).kind = FunctionKind::Local(stub);
    }
    // Only other functions of the later part call these.
    for &id in later
        .iter()
        .filter(|id| border.entries.binary_search(id).is_err())
    {
        module.funcs.delete(id);
    }
    passes::gc::run(module);
    Ok(())
}

/// A function that sees to it that the table is filled.
fn ready(module: &mut Module, table: TableId, load: FunctionId) -> FunctionId {
    let mut builder = FunctionBuilder::new(&mut module.types, &[], &[]);
    builder
        .func_body()
        .i32_const(0)
        .table_get(table)
        .ref_is_null()
        .if_else(
            None,
            |then| {
                then.call(load);
            },
            |_| {},
        );
    builder.finish(Vec::new(), &mut module.funcs)
}

fn stub(
    module: &mut Module,
    id: FunctionId,
    table: TableId,
    ready: FunctionId,
    slot: i32,
) -> LocalFunction {
    let kind = module.funcs.get(id).ty();
    let (parameters, results) = {
        let kind = module.types.get(kind);
        (kind.params().to_vec(), kind.results().to_vec())
    };
    let mut builder = FunctionBuilder::new(&mut module.types, &parameters, &results);
    let locals: Vec<_> = parameters
        .iter()
        .map(|&kind| module.locals.add(kind))
        .collect();
    let mut body = builder.func_body();
    body.call(ready);
    for &local in &locals {
        body.local_get(local);
    }
    body.const_(Value::I32(slot)).call_indirect(kind, table);
    builder.local_func(locals)
}

fn keep_later(module: &mut Module, later: &BTreeSet<FunctionId>, border: &Border) {
    for export in module
        .exports
        .iter()
        .map(walrus::Export::id)
        .collect::<Vec<_>>()
    {
        module.exports.delete(export);
    }
    module.start = None;
    for element in module
        .elements
        .iter()
        .map(walrus::Element::id)
        .collect::<Vec<_>>()
    {
        module.elements.delete(element);
    }
    for data in module.data.iter().map(walrus::Data::id).collect::<Vec<_>>() {
        module.data.delete(data);
    }
    for table in module.tables.iter_mut() {
        table.elem_segments.clear();
    }
    for memory in module.memories.iter_mut() {
        memory.data_segments.clear();
    }
    for (name, item) in border.items() {
        import(module, &name, item);
    }
    let unused: Vec<FunctionId> = module
        .funcs
        .iter()
        .map(walrus::Function::id)
        .filter(|id| !later.contains(id) && !border.shared.functions.contains(id))
        .collect();
    for id in unused {
        if let FunctionKind::Import(imported) = &module.funcs.get(id).kind {
            module.imports.delete(imported.import);
        }
        module.funcs.delete(id);
    }
    let size = border.entries.len() as u64;
    let (table, _) =
        module.add_import_table(FIRST, TABLE, false, size, Some(size), RefType::FUNCREF);
    let kind = ElementKind::Active {
        table,
        offset: ConstExpr::Value(Value::I32(0)),
    };
    let element = module
        .elements
        .add(kind, ElementItems::Functions(border.entries.clone()));
    module.tables.get_mut(table).elem_segments.insert(element);
    passes::gc::run(module);
}

/// Makes of what a module has something that it imports from the first part.
fn import(module: &mut Module, name: &str, item: ExportItem) {
    match item {
        ExportItem::Function(id) => {
            let kind = module.funcs.get(id).ty();
            if let FunctionKind::Import(imported) = &module.funcs.get(id).kind {
                module.imports.delete(imported.import);
            }
            let import = module.imports.add(FIRST, name, id);
            module.funcs.get_mut(id).kind =
                FunctionKind::Import(ImportedFunction { import, ty: kind });
        }
        ExportItem::Global(id) => {
            let import = module.imports.add(FIRST, name, id);
            module.globals.get_mut(id).kind = GlobalKind::Import(import);
        }
        ExportItem::Memory(id) => {
            let import = module.imports.add(FIRST, name, id);
            module.memories.get_mut(id).import = Some(import);
        }
        ExportItem::Table(id) => {
            let import = module.imports.add(FIRST, name, id);
            module.tables.get_mut(id).import = Some(import);
        }
        // wasm-bindgen makes none without exceptions.
        ExportItem::Tag(_) => {}
    }
}
