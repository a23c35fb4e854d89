//! Has a program note which of its functions run: each has a global of its own, which the program
//! exports under the function's number and which is 1 once the function has begun.

use std::error::Error;
use std::fmt::Write as _;

use walrus::ir::{Const, GlobalSet, Value};
use walrus::{ConstExpr, FunctionId, FunctionKind, Module, ValType};

use crate::choice::without_hashes;

/// A program that notes what runs.
pub(crate) struct Counted {
    pub(crate) wasm: Vec<u8>,
    /// The functions in the order of their numbers, a line each: how many bytes the function has,
    /// and its name.
    pub(crate) functions: String,
}

/// Has each function of bound Wasm noted that runs.
///
/// # Errors
/// Where it is no Wasm.
pub(crate) fn count(wasm: &[u8]) -> Result<Counted, Box<dyn Error>> {
    let mut module = Module::from_buffer(wasm).map_err(|error| format!("{error:#}"))?;
    let functions: Vec<FunctionId> = module.funcs.iter_local().map(|(id, _)| id).collect();
    let mut told = String::new();
    for (number, &id) in functions.iter().enumerate() {
        let zero = ConstExpr::Value(Value::I32(0));
        let global = module.globals.add_local(ValType::I32, true, false, zero);
        module.exports.add(&format!("ran{number}"), global);
        let function = module.funcs.get_mut(id);
        let name = without_hashes(function.name.as_deref().unwrap_or_default());
        if let FunctionKind::Local(local) = &mut function.kind {
            let _ = writeln!(told, "{} {name}", local.size());
            let one = Const {
                value: Value::I32(1),
            };
            let builder = local.builder_mut();
            builder.func_body().instr_at(0, one);
            builder.func_body().instr_at(1, GlobalSet { global });
        }
    }
    Ok(Counted {
        wasm: module.emit_wasm(),
        functions: told,
    })
}
