//! A program as text without XML: its head, its locals and its code. Programs are shown and written in this form.
//!
//! ```text
//! public program pick(num x_nCount, string& x_sName, point x_pPlaces[])
//!   num l_nIndex
//!   point l_pNear[3]
//! begin
//!   l_nIndex=0
//! end
//! ```

mod read;
mod write;

pub use write::write_program;

use val3_analysis::db::{Db, File};
use val3_analysis::items::program::{Header, LocalDecl, ParamDecl, header};
use val3_analysis::ty::brackets;
use val3_lang::types::Container;

use crate::code_text;
use crate::hover::shape;

/// Program in a file as text. `None` if the file has no program, or if its declarations cannot be read.
pub fn program_text(db: &dyn Db, file: File) -> Option<String> {
    let header = header(db, file);
    if !header.complete {
        return None;
    }
    let code = code_text(db, file)?;
    let locals: String = header.locals.iter().map(|local| format!("  {}\n", local_text(local))).collect();
    Some(format!("{}\n{locals}{}\n", head(header), code.trim().replace("\r\n", "\n")))
}

/// First line of a program.
fn head(Header { name, public, params, .. }: &Header) -> String {
    let access = if *public { "public " } else { "" };
    let params: Vec<String> = params.iter().map(param_text).collect();
    format!("{access}program {name}({})", params.join(", "))
}

fn param_text(ParamDecl { name, type_name, container, by_reference, .. }: &ParamDecl) -> String {
    // Containers are always passed by reference.
    let reference = if *by_reference && *container == Container::Element { "&" } else { "" };
    format!("{type_name}{reference} {name}{}", brackets(*container))
}

fn local_text(LocalDecl { name, type_name, container, sizes }: &LocalDecl) -> String {
    format!("{type_name} {name}{}", shape(sizes, *container))
}

#[cfg(test)]
mod tests;
