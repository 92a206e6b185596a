//! Purpose of the string at the cursor, determined from the instruction that reads it.

use smol_str::SmolStr;
use val3_analysis::db::Project;
use val3_analysis::ty::Base;
use val3_lang::arguments::TextForm;
use val3_lang::instruction::Family;
use val3_lang::instructions;
use val3_lang::types::Container;
use val3_syntax::SyntaxKind::*;

use crate::line::{CallSite, LineTokens, VisibleNames, string_text};

/// Possible contents of a string.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum TextPlace {
    /// Path of a library, with the library identifier if the path is loaded.
    LibraryPath(Option<SmolStr>),
    /// A name in a library's interface.
    LibraryItem(SmolStr),
    /// A task of the application.
    Task,
    /// A data name, restricted to this type.
    DataName(Option<Base>),
    /// A format.
    Format(TextForm),
    /// A parameter of a serial line.
    SerialParameter,
    /// A value of this serial line parameter.
    SerialValue(String),
    /// A key of a collection.
    Key(Collection),
}

/// A global collection.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Collection {
    /// Project that declares it.
    pub(super) project: Project,
    /// Name.
    pub(super) name: SmolStr,
}

/// Purpose of the string at the cursor; `None` if it is unknown.
pub(super) fn text_place(names: &VisibleNames<'_>, line: &LineTokens) -> Option<TextPlace> {
    if let Some(collection) = collection(names, line) {
        return Some(TextPlace::Key(collection));
    }
    let call = CallSite::around(line).filter(|call| !call.callee.is_program)?;
    let instruction = instructions::find(&call.callee.name)?;
    let form = names.form(&call, call.active)?;
    let parameter = form.params.get(call.active)?;
    if let Some(format) = val3_lang::arguments::text_form(instruction.name, parameter.name) {
        return Some(TextPlace::Format(format));
    }
    match instruction.name {
        instructions::LIB_EXIST => call.callee.library.clone().map(TextPlace::LibraryItem),
        instructions::GET_DATA if call.active == 0 => {
            let target = call.arguments.get(1).map(|target| names.ty(target).base);
            Some(TextPlace::DataName(target.filter(|base| *base != Base::Unknown)))
        }
        instructions::SIO_CTRL if call.active == 1 => Some(TextPlace::SerialParameter),
        instructions::SIO_CTRL => {
            let parameter = call.arguments.get(1).and_then(|argument| argument.first())?;
            (parameter.kind() == STRING).then(|| TextPlace::SerialValue(string_text(parameter)))
        }
        name if instructions::ON_TASKS.contains(&name) => Some(TextPlace::Task),
        instructions::LIB_LOAD => Some(TextPlace::LibraryPath(call.callee.library.clone())),
        _ if instruction.family == Family::Libraries && parameter.name == "sPath" => Some(TextPlace::LibraryPath(None)),
        _ => None,
    }
}

/// Collection before an opening bracket, for example `dIn[` or `library:dIn[`.
pub(super) fn collection(names: &VisibleNames<'_>, line: &LineTokens) -> Option<Collection> {
    let (_, head) = line.before().split_last().filter(|(bracket, _)| bracket.kind() == L_BRACK)?;
    let (name, before) = head.split_last().filter(|(name, _)| name.kind() == IDENT)?;
    if names.ty(head).container != Container::Collection {
        return None;
    }
    let project = match before.split_last() {
        Some((colon, library)) if colon.kind() == COLON => names.interface(library.last()?.text())?,
        Some((dot, _)) if dot.kind() == DOT => return None,
        _ => names.project,
    };
    Some(Collection { project, name: name.text().into() })
}
