//! Where the cursor is, and what that place takes.

use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, body};
use val3_analysis::db::{Db, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::parse;
use val3_analysis::ty::Base;
use val3_lang::instructions;
use val3_syntax::{SyntaxKind, SyntaxToken, TextRange, TextSize};

use crate::FilePosition;
use crate::signature_help::{argument, call_around};

/// What a place takes.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Context {
    /// Nothing that could be proposed.
    Nothing,
    /// A line of code; `closing` is the keyword that ends the block around it.
    Statement {
        /// `endIf`, `until` …
        closing: Option<&'static str>,
    },
    /// A value.
    Expression {
        /// Its type, where the place tells.
        expected: Option<Base>,
    },
    /// A field of a value.
    Members(Base),
    /// An item of a library.
    LibraryItem {
        /// The identifier.
        library: SmolStr,
        /// Behind `call`.
        programs_only: bool,
    },
    /// A program.
    Program,
    /// The text of a string: the instruction it is an argument of, and its place among the arguments.
    Text(TextPlace),
    /// The value of an attribute.
    Attribute(AttributePlace),
}

/// A string in code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct TextPlace {
    /// The instruction, or the keyword of a statement.
    pub(super) callee: SmolStr,
    /// The library identifier before it, if there is one.
    pub(super) library: Option<SmolStr>,
    /// The argument, from 0.
    pub(super) argument: usize,
}

/// The value of an attribute.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct AttributePlace {
    /// The element.
    pub(super) element: String,
    /// The attribute.
    pub(super) attribute: String,
    /// The type of the data around it, where the element lies in one.
    pub(super) data_type: Option<String>,
}

/// What the place of a position takes, and the letters that stand there already.
pub(super) fn context(db: &dyn Db, project: Project, at: FilePosition) -> (Context, TextRange) {
    let root = parse(db, at.file).root();
    let empty = TextRange::empty(at.offset);
    if !root.text_range().contains_inclusive(at.offset) {
        return (Context::Nothing, empty);
    }
    let Some(token) = root.token_at_offset(at.offset).left_biased() else { return (Context::Nothing, empty) };
    let in_code = token.parent_ancestors().any(|node| node.kind() == SyntaxKind::CODE);
    match token.kind() {
        SyntaxKind::COMMENT | SyntaxKind::XML_COMMENT | SyntaxKind::NUMBER => (Context::Nothing, empty),
        SyntaxKind::STRING => string(db, at, &token),
        SyntaxKind::XML_STRING => attribute(at, &token),
        _ if in_code => code(db, project, at, &token),
        _ => (Context::Nothing, empty),
    }
}

/// The word that ends at the cursor.
fn word(token: &SyntaxToken, offset: TextSize) -> TextRange {
    let is_word = token.kind() == SyntaxKind::IDENT || token.kind().is_keyword();
    if is_word { TextRange::new(token.text_range().start(), offset) } else { TextRange::empty(offset) }
}

fn code(db: &dyn Db, project: Project, at: FilePosition, token: &SyntaxToken) -> (Context, TextRange) {
    let typed = word(token, at.offset);
    let text: &str = at.file.text(db);
    let line = line_before(text, typed.start());
    let before = line.trim_end();
    if line.trim_start().starts_with("//") {
        return (Context::Nothing, typed);
    }
    let context = if before.is_empty() {
        Context::Statement { closing: closing(token) }
    } else if let Some(head) = before.strip_suffix('.') {
        let end = typed.start() - TextSize::of(line) + TextSize::of(head);
        members(db, project, at, end)
    } else if let Some(head) = before.strip_suffix(':') {
        let library = head.rsplit(|letter: char| !(letter.is_alphanumeric() || letter == '_')).next().unwrap_or("");
        let programs_only = first_word(head) == "call" || is_task_call(head);
        Context::LibraryItem { library: library.into(), programs_only }
    } else if before == first_word(before) && before.trim_start() == "call" || is_task_call(before) {
        Context::Program
    } else {
        Context::Expression { expected: expected(db, project, at, before) }
    };
    (context, typed)
}

/// The code of the line before an offset, without the XML before it.
fn line_before(text: &str, end: TextSize) -> &str {
    let before = text.get(..usize::from(end)).unwrap_or("");
    let line = before.rsplit(['\n', '\r']).next().unwrap_or("");
    line.rsplit(['>'])
        .next()
        .filter(|_| line.contains("<![CDATA["))
        .map_or(line, |code| code.rsplit("[").next().unwrap_or(code))
}

fn first_word(line: &str) -> &str {
    line.split_whitespace().next().unwrap_or("")
}

/// Behind the last comma of a `taskCreate` stands the program.
fn is_task_call(before: &str) -> bool {
    let word = first_word(before);
    let commas = match () {
        () if word.eq_ignore_ascii_case("taskCreate") => 2,
        () if word.eq_ignore_ascii_case("taskCreateSync") => 3,
        () => return false,
    };
    let last = before.rsplit(',').next().unwrap_or("");
    before.matches(',').count() >= commas && !last.contains('(')
}

/// The keyword that ends the innermost open block.
fn closing(token: &SyntaxToken) -> Option<&'static str> {
    token.parent_ancestors().find_map(|node| {
        Some(match node.kind() {
            SyntaxKind::IF_STMT => "endIf",
            SyntaxKind::WHILE_STMT => "endWhile",
            SyntaxKind::FOR_STMT => "endFor",
            SyntaxKind::DO_STMT => "until",
            SyntaxKind::CASE_CLAUSE | SyntaxKind::DEFAULT_CLAUSE => "break",
            SyntaxKind::SWITCH_STMT => "endSwitch",
            _ => return None,
        })
    })
}

/// The type of the expression that ends at `end`.
fn members(db: &dyn Db, project: Project, at: FilePosition, end: TextSize) -> Context {
    let body = body(db, at.file);
    let ending = body
        .exprs()
        .filter(|(_, expr, range)| range.end() == end && !matches!(expr, Expr::Binary(..) | Expr::Assign(..)));
    let Some((id, ..)) = ending.max_by_key(|(_, _, range)| range.len()) else { return Context::Nothing };
    Context::Members(infer(db, project, at.file).ty(id).base)
}

/// The type that the place asks for: that of the parameter, or of the other side of `=` or a comparison.
fn expected(db: &dyn Db, project: Project, at: FilePosition, before: &str) -> Option<Base> {
    let body = body(db, at.file);
    let text: &str = at.file.text(db);
    if let Some((callee, args)) = call_around(body, text, at.offset) {
        return parameter(db, project, at, body, callee, args, argument(text, body, callee, at.offset));
    }
    let operator = ["==", "!=", "<=", ">=", "=", "<", ">"].into_iter().find(|operator| before.ends_with(operator))?;
    let end = at.offset - TextSize::of(behind(text, at.offset, before)) - TextSize::of(operator);
    let left = body.exprs().filter(|(_, _, range)| range.end() <= end && range.end() + TextSize::new(2) >= end);
    let (id, ..) = left.max_by_key(|(_, _, range)| (range.end(), range.len()))?;
    let base = infer(db, project, at.file).ty(id).base;
    (base != Base::Unknown).then_some(base)
}

/// What stands between the end of `before` and the cursor.
fn behind<'t>(text: &'t str, offset: TextSize, before: &str) -> &'t str {
    let line = text.get(..usize::from(offset)).unwrap_or("");
    line.rfind(before).and_then(|at| line.get(at + before.len()..)).unwrap_or("")
}

fn parameter(
    db: &dyn Db,
    project: Project,
    at: FilePosition,
    body: &Body,
    callee: ExprId,
    args: &[ExprId],
    index: usize,
) -> Option<Base> {
    if let Some(signature) = val3_analysis::effects::Effects::new(db, project, at.file).program(callee) {
        return signature.params.get(index).map(|param| param.base);
    }
    let name = match body.expr(callee) {
        Expr::Name(name) | Expr::Path { item: name, .. } => name,
        _ => return None,
    };
    let forms = instructions::find(name)?.overloads;
    let fits = |form: &&val3_lang::instruction::Overload| {
        form.params.len() > index
            && form.params.iter().zip(args).take(index).all(|(param, arg)| {
                let base = infer(db, project, at.file).ty(*arg).base;
                param.ty.is_none_or(|ty| base.same_as(Base::of(ty)))
            })
    };
    let form = forms.iter().find(fits)?;
    form.params.get(index)?.ty.map(Base::of)
}

/// The inside of a string, up to the cursor.
fn string(db: &dyn Db, at: FilePosition, token: &SyntaxToken) -> (Context, TextRange) {
    let range = token.text_range();
    let start = range.start() + TextSize::new(1);
    let closed = token.text().len() > 1 && token.text().ends_with('"');
    if at.offset < start || closed && at.offset == range.end() || !token.text().starts_with('"') {
        return (Context::Nothing, TextRange::empty(at.offset));
    }
    let end = if closed { range.end() - TextSize::new(1) } else { range.end() };
    let typed = TextRange::new(start, end);
    let body = body(db, at.file);
    let text: &str = at.file.text(db);
    let place = match call_around(body, text, at.offset) {
        Some((callee, _)) => text_place(body, callee, argument(text, body, callee, at.offset)),
        None => None,
    };
    (place.map_or(Context::Nothing, Context::Text), typed)
}

fn text_place(body: &Body, callee: ExprId, argument: usize) -> Option<TextPlace> {
    let (callee, library) = match body.expr(callee) {
        Expr::Name(name) => (name.clone(), None),
        Expr::Path { library, item } => (item.clone(), Some(library.clone())),
        _ => return None,
    };
    Some(TextPlace { callee, library, argument })
}

/// The inside of an attribute's value.
fn attribute(at: FilePosition, token: &SyntaxToken) -> (Context, TextRange) {
    let range = token.text_range();
    let inside = TextRange::new(
        range.start() + TextSize::new(1),
        (range.end() - TextSize::new(1)).max(range.start() + TextSize::new(1)),
    );
    let Some(attribute) = token.parent().filter(|_| inside.contains_inclusive(at.offset)) else {
        return (Context::Nothing, TextRange::empty(at.offset));
    };
    let name_of = |node: &val3_syntax::SyntaxNode| {
        node.children_with_tokens()
            .filter_map(|child| child.into_token())
            .find(|token| token.kind() == SyntaxKind::XML_NAME)
            .map(|token| token.text().to_owned())
    };
    let Some(tag) = attribute.parent() else { return (Context::Nothing, inside) };
    let place = AttributePlace {
        element: name_of(&tag).unwrap_or_default(),
        attribute: name_of(&attribute).unwrap_or_default(),
        data_type: data_type(&tag),
    };
    (Context::Attribute(place), inside)
}

/// The `type` of the innermost element around a tag that has one.
fn data_type(tag: &val3_syntax::SyntaxNode) -> Option<String> {
    tag.ancestors().filter(|node| node.kind() == SyntaxKind::ELEMENT).find_map(|element| {
        let start = element.children().find(|child| child.kind() == SyntaxKind::START_TAG)?;
        start.children().find_map(|attribute| {
            let text = attribute.text().to_string();
            let value = text.trim().strip_prefix("type")?.trim_start().strip_prefix('=')?;
            Some(value.trim().trim_matches(['"', '\'']).to_owned())
        })
    })
}
