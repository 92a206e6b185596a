//! What the name under the cursor is: type, initial value, father, comment, page.

mod data;
mod program;

pub(crate) use data::keys_of;
pub(crate) use program::{comment as program_comment, line as program_line};

use val3_analysis::body::{Constant, Expr, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::parse;
use val3_analysis::items::program::header;
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::brackets;
use val3_lang::types::{Arm, BaseType, Unit, field};
use val3_lang::{builtins, enumerations, instructions, page, statements};
use val3_syntax::{SyntaxKind, TextRange};

use crate::FilePosition;
use crate::navigate::name_at;
use crate::owner::owner;

/// A text about a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hover {
    /// What it is about.
    pub range: TextRange,
    /// The text in Markdown.
    pub markdown: String,
}

/// What there is to say about a position.
pub fn hover(db: &dyn Db, at: FilePosition) -> Option<Hover> {
    if let Some((project, found)) = name_at(db, at) {
        let markdown = symbol(db, project, &found.symbol)?;
        return Some(Hover { range: found.range, markdown });
    }
    keyword(db, at).or_else(|| constant(db, at))
}

/// What there is to say about a symbol that is named in `project`.
pub(crate) fn symbol(db: &dyn Db, project: Project, symbol: &Symbol) -> Option<String> {
    match symbol {
        Symbol::Local(file, name) => {
            let header = header(db, *file);
            let local = header.locals.iter().find(|local| local.name == *name)?;
            Some(
                fenced(&format!("{} {name}{}", local.type_name, shape(&local.sizes, local.container)))
                    + "\nlocal variable",
            )
        }
        Symbol::Param(file, name) => {
            let header = header(db, *file);
            let param = header.params.iter().find(|param| param.name == *name)?;
            let reference = if param.by_reference { "&" } else { "" };
            let line = format!("{}{reference} {name}{}", param.type_name, brackets(param.container));
            let passing = if param.by_reference { "by reference" } else { "by value" };
            Some(fenced(&line) + &format!("\nparameter, {passing}"))
        }
        Symbol::Data(owner, name) => data::hover(db, *owner, name),
        Symbol::Program(owner, name) => program::hover(db, *owner, name),
        Symbol::Library(owner, name) => library(db, *owner, name),
        Symbol::Type(owner, name) => user_type(db, *owner, name),
        Symbol::Instruction(name) => instruction(name),
        Symbol::Builtin(name) => {
            builtins::find(name).map(|found| fenced(&format!("{} {name}", found.ty.name())) + "\n" + found.doc)
        }
        Symbol::Enumerator(name) => {
            enumerations::find(name).map(|found| fenced(&format!("{} {name}", found.ty.name())) + "\n" + found.doc)
        }
        Symbol::Field(ty, name) => builtin_field(*ty, items(db, project).arm, name),
        Symbol::BuiltinType(name) => Some(fenced(name)),
    }
}

/// A block of code.
fn fenced(code: &str) -> String {
    format!("```val3\n{code}\n```\n")
}

/// The brackets of a declaration: `[3,4]`, `[""]`, nothing for a single value.
fn shape(sizes: &[u32], container: val3_lang::types::Container) -> String {
    match sizes {
        [1] => String::new(),
        [] => brackets(container).to_owned(),
        _ => format!("[{}]", sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(",")),
    }
}

/// The path of a project's folder, from the disk's root on where that is known.
fn place_of(db: &dyn Db, project: Project) -> String {
    let path = project.manifest(db).path(db);
    match project.disk(db).as_ref().and_then(|disk| path.strip_prefix(disk).ok()) {
        Some(relative) => format!("`Disk://{relative}`"),
        None => format!("`{path}`"),
    }
}

fn library(db: &dyn Db, owner: Project, name: &str) -> Option<String> {
    let library = items(db, owner).libraries.get(name)?;
    let loading = if library.autoload { "loaded with the application" } else { "loaded by `libLoad`" };
    let interface = library.interface.map_or_else(|| "an unknown library".to_owned(), |project| place_of(db, project));
    Some(fenced(&format!("library {name}")) + &format!("\ninterface of {interface}, {loading}"))
}

fn user_type(db: &dyn Db, owner: Project, name: &str) -> Option<String> {
    let project = items(db, owner).types.get(name).copied().flatten()?;
    let mut fields: Vec<_> = items(db, project).data.iter().filter(|(_, item)| item.decl.public).collect();
    fields.sort_unstable_by_key(|(name, _)| *name);
    let lines: String = fields
        .iter()
        .map(|(name, item)| {
            format!("  {} {name}{}\n", item.decl.type_name, shape(&item.decl.sizes, item.decl.container))
        })
        .collect();
    Some(fenced(&format!("type {name}\n{}", lines.trim_end())) + &format!("\nuser type of {}", place_of(db, project)))
}

/// The forms of an instruction and its page.
fn instruction(name: &str) -> Option<String> {
    let found = instructions::find(name)?;
    Some(fenced(&found.signatures().join("\n")) + "\n" + &page::text(found.page))
}

fn builtin_field(ty: BaseType, arm: Option<Arm>, name: &str) -> Option<String> {
    let found = field(ty, arm, name)?;
    let unit = unit(found.unit).map(|unit| format!(" ({unit})")).unwrap_or_default();
    Some(fenced(&format!("{} {}.{name}", found.ty.name(), ty.name())) + &format!("\n{}{unit}", found.doc))
}

fn unit(unit: Unit) -> Option<&'static str> {
    Some(match unit {
        Unit::None => return None,
        Unit::Length => "mm or inches",
        Unit::Degrees => "degrees",
        Unit::Percent => "per cent of the arm's nominal value",
        Unit::LengthPerSecond => "mm or inches per second",
        Unit::DegreesPerSecond => "degrees per second",
        Unit::Seconds => "seconds",
    })
}

/// The page of a keyword.
fn keyword(db: &dyn Db, at: FilePosition) -> Option<Hover> {
    let root = parse(db, at.file).root();
    let tokens = root.text_range().contains_inclusive(at.offset).then(|| root.token_at_offset(at.offset))?;
    let token = tokens.into_iter().find(|token| token.kind().is_keyword() || token.kind() == SyntaxKind::QUESTION)?;
    let found = statements::find(token.text())?;
    Some(Hover { range: token.text_range(), markdown: page::text(found.page) })
}

/// The value of an expression that is made of literals.
fn constant(db: &dyn Db, at: FilePosition) -> Option<Hover> {
    owner(db, at.file)?;
    let body = body(db, at.file);
    let around = body.exprs().filter(|(_, expr, range)| {
        range.contains_inclusive(at.offset) && matches!(expr, Expr::Binary(..) | Expr::Unary(..) | Expr::Paren(_))
    });
    let (id, _, range) = around.max_by_key(|(_, _, range)| range.len())?;
    let value = match body.constant(id)? {
        Constant::Number(value) => value.to_string(),
        Constant::String(text) => format!("\"{text}\""),
        Constant::Bool(value) => value.to_string(),
    };
    Some(Hover { range, markdown: fenced(&value) })
}

/// The type of the expression that is selected, or the innermost one around a position.
pub fn type_at(db: &dyn Db, file: File, range: TextRange) -> Option<(TextRange, String)> {
    let project = owner(db, file)?;
    let body = body(db, file);
    let around = body.exprs().filter(|(_, _, found)| found.contains_range(range));
    let (id, _, found) = around.min_by_key(|(_, _, found)| found.len())?;
    let ty = infer(db, project, file).ty(id);
    (!ty.is_unknown()).then(|| (found, ty.display(db).to_string()))
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::Marked;

    fn check(listing: &str, expected: Expect) {
        let marked = Marked::new(listing);
        let found = hover(marked.db(), marked.at()).map_or_else(|| "nothing".to_owned(), |hover| hover.markdown);
        expected.assert_eq(&(found + "\n"));
    }

    #[test]
    fn variables() {
        check(
            "num nCount = 3\nnC$0ount=1",
            expect![[r#"
            ```val3
            num nCount
            ```

            starts as
            ```val3
            3
            ```

        "#]],
        );
        check(
            "string sName = \"box\"\nput(sNam$0e)",
            expect![[r#"
            ```val3
            string sName
            ```

            starts as
            ```val3
            box
            ```

        "#]],
        );
        check(
            "frame fTable\npoint pA\npA.trsf=fTa$0ble.trsf",
            expect![[r#"
            ```val3
            frame fTable
            ```

            starts as
            ```val3
            fatherId=world[0]
            ```

            hangs on `world`

        "#]],
        );
        check(
            "program start(num& x_n)\nbegin\n  put(x_n$0)\nend",
            expect![[r#"
            ```val3
            num& x_n
            ```

            parameter, by reference
        "#]],
        );
        check(
            "program start()\n  num l_a[3]\nbegin\n  put(l_$0a[1])\nend",
            expect![[r#"
            ```val3
            num l_a[3]
            ```

            local variable
        "#]],
        );
    }

    #[test]
    fn programs_have_their_comment() {
        check(
            "call gr$0ip(1)\nprogram grip(num x_n, string& x_s)\nbegin\n  // Closes the gripper.\n  //\\param x_n how hard\n  putln(x_n)\nend",
            expect![[r#"
                ```val3
                program grip(num x_n, string& x_s)
                ```

                Closes the gripper.
                - `x_n`: how hard
            "#]],
        );
    }

    #[test]
    fn libraries_and_types() {
        check(
            "library part \"Disk://part/part.pjx\"\npa$0rt:nA=1\n--- part\npublic num nA",
            expect![[r#"
            ```val3
            library part
            ```

            interface of `Disk://part/part.pjx`, loaded with the application
        "#]],
        );
        check(
            "type Slot \"Disk://Slot/Slot.pjx\"\nSlot sA\nput(sA.nHei$0ght)\n--- Slot\npublic num nHeight = 4",
            expect![[r#"
            ```val3
            public num nHeight
            ```

            starts as
            ```val3
            4
            ```

        "#]],
        );
    }

    #[test]
    fn what_the_language_brings() {
        check(
            "num nA\nnA=sqr$0t(4)",
            expect![[r#"
            ```val3
            num sqrt(num nValue)
            ```

            Gives the square root of a number.

            - `nValue`: 0 or more.
            - Result: the root.
            - Error 11: `nValue` is negative.

            ## Example
            ```val3
            num nDistance
            trsf trGap
              nDistance=sqrt(trGap.x*trGap.x+trGap.y*trGap.y)
            ```

        "#]],
        );
        check(
            "point pA\npA.trsf.r$0x=1",
            expect![[r#"
            ```val3
            num trsf.rx
            ```

            First rotation, about x. (degrees)
        "#]],
        );
        check(
            "if tr$0ue\nendIf",
            expect![[r#"
            The two truth values.

            ## Example
            ```val3
            bool bDone
              bDone=true
              wait(bDone)
            ```

        "#]],
        );
        check(
            "whi$0le true\n  delay(1)\nendWhile",
            expect![[r#"
            Repeats lines as long as a condition holds.

            The condition is computed before each pass, so the lines may not be executed at all. A loop that waits for
            something needs a `delay` or another instruction that lets the other tasks run.

            ## Example
            ```val3
            dio doLamp
              while isSettled()==false
                doLamp=!doLamp
                delay(0.5)
              endWhile
              doLamp=false
            ```

        "#]],
        );
        check(
            "mdesc mA\nmA.blend=jo$0int",
            expect![[r#"
            ```val3
            blend joint
            ```

            Rounds the corner with a joint move: fast, free in shape.
        "#]],
        );
    }

    #[test]
    fn constants() {
        check(
            "num nA\nnA=2*$0(3+4)",
            expect![[r#"
            ```val3
            14
            ```

        "#]],
        );
    }
}
