//! Expected types for unresolved names, derived from the context.

use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind};
use val3_analysis::db::Db;
use val3_analysis::infer::Inference;
use val3_analysis::items::project::{items, signature};
use val3_analysis::ty::{Base, Ty};
use val3_lang::instruction::Overload;
use val3_lang::instructions;
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_lang::types::{Arm, BaseType, Container, fields};
use val3_syntax::SyntaxKind;

use super::context::Context;
use crate::declare::NewVariable;
use crate::variables::declares_variable;

/// An unresolved name in the code.
pub(super) struct UnknownName {
    pub(super) name: SmolStr,
    /// Expected type.
    variable: Ty,
}

/// The unresolved variable at the cursor.
pub(super) fn unknown(context: &Context<'_>) -> Option<UnknownName> {
    let token = context.token().filter(|token| token.kind() == SyntaxKind::IDENT)?;
    let range = token.text_range();
    let id = context.expr_at(range)?;
    let Expr::Name(name) = context.body().expr(id) else { return None };
    let known = declares_variable(context.header(), name)
        || context.items().data.contains_key(name)
        || val3_lang::builtins::find(name).is_some()
        || val3_lang::enumerations::find(name).is_some();
    if known || is_called(context.body(), id) {
        return None;
    }
    let place = UseSite { context, body: context.body(), inference: context.inference() };
    let ty = match (place.expected(id), by_prefix(context, name)) {
        (Some(expected), Some(named)) if stands_in(expected.base, named.base) => Ty { base: named.base, ..expected },
        (expected, named) => expected.or(named).unwrap_or(Ty::of(BaseType::Num)),
    };
    Some(UnknownName { name: name.clone(), variable: ty })
}

/// Whether a value of the type `named` is also accepted where `expected` is required.
fn stands_in(expected: Base, named: Base) -> bool {
    use BaseType::{Aio, Bool, Dio, Joint, Num, Point};
    matches!(
        (expected.builtin(), named.builtin()),
        (Some(Bool), Some(Dio)) | (Some(Num), Some(Aio)) | (Some(Joint), Some(Point)) | (Some(Point), Some(Joint))
    )
}

/// Whether the name is followed by parentheses: an instruction or a program.
pub(super) fn is_called(body: &Body, id: ExprId) -> bool {
    body.exprs().any(|(_, expr, _)| matches!(expr, Expr::Call(callee, _) if *callee == id))
}

impl UnknownName {
    /// Declaration of the name. Position types of data are specific to an arm. An array gets the sizes that `bodies`
    /// require; `None` if that would exceed [`LARGEST`].
    pub(super) fn variable<'b>(
        &self,
        context: &Context<'_>,
        bound: bool,
        bodies: impl IntoIterator<Item = &'b Body>,
    ) -> Option<NewVariable> {
        let (container, sizes) = match self.variable.container {
            Container::Array { dims } => (self.variable.container, sizes(&self.name, dims, bodies)?),
            Container::Element => (Container::Array { dims: 1 }, vec![1]),
            Container::Collection => (Container::Collection, vec![1]),
        };
        let type_name = type_name(context, self.variable.base, bound);
        Some(NewVariable { name: self.name.to_string(), type_name, container, sizes })
    }

    /// Declaration as a parameter, which has a number of dimensions but no sizes.
    pub(super) fn parameter(&self, context: &Context<'_>) -> NewVariable {
        let sizes = match self.variable.container {
            Container::Array { dims } => vec![2; usize::from(dims.max(1))],
            _ => vec![1],
        };
        let type_name = type_name(context, self.variable.base, false);
        NewVariable { name: self.name.to_string(), type_name, container: self.variable.container, sizes }
    }

    /// Expected type.
    pub(super) fn ty(&self) -> Ty {
        self.variable
    }

    /// Whether it would have to be an input, an output or a serial line.
    pub(super) fn is_linkable(&self) -> bool {
        self.variable.base.builtin().is_some_and(BaseType::is_linkable)
    }

    /// Type name for a title.
    pub(super) fn shown(&self, db: &dyn Db) -> SmolStr {
        Ty::element(self.variable.base).display(db)
    }
}

/// Limit of array elements, which is not exceeded in any known program.
const LARGEST: u64 = 10_000;

/// Array sizes: for each dimension, one more than the highest known index.
fn sizes<'b>(name: &str, dims: u8, bodies: impl IntoIterator<Item = &'b Body>) -> Option<Vec<u32>> {
    let mut sizes = vec![1_u32; usize::from(dims.max(1))];
    for body in bodies {
        for (_, expr, _) in body.exprs() {
            let Expr::Index(base, indexes) = expr else { continue };
            if !matches!(body.expr(*base), Expr::Name(other) if other == name) || indexes.len() != sizes.len() {
                continue;
            }
            for (size, index) in sizes.iter_mut().zip(indexes.iter()) {
                *size = (*size).max(size_for(highest(body, *index)));
            }
        }
    }
    let elements = sizes.iter().fold(1_u64, |elements, size| elements.saturating_mul(u64::from(*size)));
    (elements <= LARGEST).then_some(sizes)
}

/// Smallest size with this index; 1 if the index is unknown or invalid.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the number is in range")]
fn size_for(index: Option<f64>) -> u32 {
    match index {
        Some(index) if index.fract() == 0.0 && index >= 0.0 => (index.min(f64::from(u32::MAX - 1)) as u32) + 1,
        _ => 1,
    }
}

/// Highest index value, if the index is a constant or a counter with constant bounds.
fn highest(body: &Body, index: ExprId) -> Option<f64> {
    if let Some(number) = body.number(index) {
        return Some(number);
    }
    let Expr::Name(name) = body.expr(body.without_parentheses(index)) else { return None };
    let place = body.range(index);
    let around = body.stmts().into_iter().filter(|stmt| stmt.range.contains_range(place));
    around.rev().find_map(|stmt| match &stmt.kind {
        StmtKind::For { counter: Some(counter), start: Some(start), stop: Some(stop), .. } => {
            let counts = matches!(body.expr(body.without_parentheses(*counter)), Expr::Name(other) if other == name);
            counts.then(|| Some(body.number(*start)?.max(body.number(*stop)?))).flatten()
        }
        _ => None,
    })
}

/// Type name in files of the project; `bound` if it has to include the arm kind.
pub(super) fn type_name(context: &Context<'_>, base: Base, bound: bool) -> String {
    let arm = context.items().arm.unwrap_or(Arm::SixAxis);
    match base {
        Base::Builtin(ty, own) if ty.depends_on_arm() && (bound || own.is_some()) => ty.file_name(own.unwrap_or(arm)),
        Base::User(project) => {
            let mut names = context.items().types.iter().filter(|(_, found)| **found == Some(project));
            names.next().map_or_else(|| base.display(context.db).to_string(), |(name, _)| name.to_string())
        }
        other => other.display(context.db).to_string(),
    }
}

/// Type that the project's naming convention assigns to the prefix of the name.
fn by_prefix(context: &Context<'_>, name: &str) -> Option<Ty> {
    let options = context.options();
    let own = [&options.local_prefix, &options.parameter_prefix];
    let name =
        own.iter().find_map(|prefix| name.strip_prefix(prefix.as_str()).filter(|_| !prefix.is_empty())).unwrap_or(name);
    let suitable = options.prefixes.iter().filter(|(_, prefix)| has_prefix(name, prefix));
    let (ty, _) = suitable.max_by_key(|(_, prefix)| prefix.len())?;
    val3_analysis::items::project::resolve_type(&context.items().types, ty).map(Ty::element)
}

/// Whether the name is the prefix and a rest that does not continue its lower-case letters: `n` is the prefix of
/// `nCount`, but not of `next`.
fn has_prefix(name: &str, prefix: &str) -> bool {
    name.strip_prefix(prefix).is_some_and(|rest| rest.starts_with(|letter: char| !letter.is_ascii_lowercase()))
}

struct UseSite<'c, 'db> {
    context: &'c Context<'db>,
    body: &'db Body,
    inference: &'db Inference,
}

impl UseSite<'_, '_> {
    /// Expected type of `id`; `None` if the context does not determine it.
    fn expected(&self, id: ExprId) -> Option<Ty> {
        let parent = self.body.exprs().find(|(_, expr, _)| holds(expr, id));
        match parent {
            Some((parent, expr, _)) => self.in_expr(id, parent, expr),
            None => self.body.stmts().into_iter().find_map(|stmt| self.in_stmt(id, &stmt.kind)),
        }
    }

    fn known(&self, id: ExprId) -> Option<Ty> {
        let ty = self.inference.ty(id);
        (!ty.is_unknown()).then(|| Ty::element(ty.base))
    }

    fn in_expr(&self, id: ExprId, parent: ExprId, expr: &Expr) -> Option<Ty> {
        match expr {
            Expr::Paren(_) => self.expected(parent),
            Expr::Unary(UnaryOp::Not, _) => Some(Ty::of(BaseType::Bool)),
            Expr::Unary(..) => Some(Ty::of(BaseType::Num)),
            Expr::Binary(BinaryOp::And | BinaryOp::Or | BinaryOp::Xor, ..) => Some(Ty::of(BaseType::Bool)),
            Expr::Binary(_, left, right) => self.known(if *left == id { *right } else { *left }),
            Expr::Assign(target, value) => self.known(if *target == id { *value } else { *target }),
            Expr::Index(base, indexes) if *base == id => self.indexed(parent, indexes),
            Expr::Index(base, _) => Some(Ty::of(match self.inference.ty(*base).container {
                Container::Collection => BaseType::String,
                _ => BaseType::Num,
            })),
            Expr::Field { field, .. } => with_field(field),
            Expr::Call(callee, arguments) => {
                let position = arguments.iter().position(|argument| *argument == id)?;
                self.argument(parent, *callee, arguments, position)
            }
            _ => None,
        }
    }

    /// A name before brackets is an array, or a collection if the brackets contain a string.
    fn indexed(&self, whole: ExprId, indexes: &[ExprId]) -> Option<Ty> {
        let element = self.expected(whole).unwrap_or(Ty::of(BaseType::Num));
        let text = indexes.first().is_some_and(|index| self.known(*index) == Some(Ty::of(BaseType::String)));
        let dims = u8::try_from(indexes.len()).ok()?;
        let container = if text { Container::Collection } else { Container::Array { dims } };
        Some(Ty { base: element.base, container })
    }

    fn argument(&self, call: ExprId, callee: ExprId, arguments: &[ExprId], position: usize) -> Option<Ty> {
        if let Some(param) = self.program(callee).and_then(|signature| signature.params.get(position)) {
            return Some(Ty { base: param.base, container: param.container });
        }
        let name = match self.body.expr(callee) {
            Expr::Name(name) => name,
            Expr::Path { item, .. } => item,
            _ => return None,
        };
        let own = self.inference.call(call).and_then(|call| call.form);
        let form = own.or_else(|| instructions::find(name)?.overloads.iter().find(|form| self.suits(form, arguments)));
        form?.params.get(position)?.ty.map(Ty::of)
    }

    /// Whether the form has as many parameters as the call has arguments, and no known argument has another type.
    fn suits(&self, form: &Overload, arguments: &[ExprId]) -> bool {
        form.params.len() == arguments.len()
            && form.params.iter().zip(arguments).all(|(param, argument)| {
                let ty = self.known(*argument).and_then(|ty| ty.base.builtin());
                param.ty.is_none() || ty.is_none() || ty == param.ty
            })
    }

    fn program(&self, callee: ExprId) -> Option<&val3_analysis::items::project::Signature> {
        let context = self.context;
        let (project, name) = match self.body.expr(callee) {
            Expr::Name(name) => (context.project, name),
            Expr::Path { library, item } => (context.items().libraries.get(library)?.interface?, item),
            _ => return None,
        };
        Some(signature(context.db, project, *items(context.db, project).programs.get(name)?))
    }

    fn in_stmt(&self, id: ExprId, stmt: &StmtKind) -> Option<Ty> {
        match stmt {
            StmtKind::If { arms, .. } => {
                arms.iter().any(|(condition, _)| *condition == Some(id)).then_some(Ty::of(BaseType::Bool))
            }
            StmtKind::While { condition, .. } | StmtKind::Do { condition, .. } => {
                (*condition == Some(id)).then_some(Ty::of(BaseType::Bool))
            }
            StmtKind::For { counter, start, stop, step, .. } => {
                [counter, start, stop, step].contains(&&Some(id)).then_some(Ty::of(BaseType::Num))
            }
            StmtKind::Switch { selector, cases } => {
                let values = || cases.iter().flat_map(|(values, _)| values);
                if *selector == Some(id) {
                    return values().find_map(|value| self.known(*value));
                }
                values().find(|value| **value == id).and_then(|_| self.known((*selector)?))
            }
            StmtKind::Assign { target, value } if *target == id => self.known(*value),
            StmtKind::Assign { target, value } if *value == id => self.known(*target),
            _ => None,
        }
    }
}

/// Whether `id` is a direct subexpression of `expr`.
fn holds(expr: &Expr, id: ExprId) -> bool {
    match expr {
        Expr::Paren(inner) | Expr::Unary(_, inner) | Expr::Field { base: inner, .. } => *inner == id,
        Expr::Binary(_, left, right) | Expr::Assign(left, right) => *left == id || *right == id,
        Expr::Index(base, parts) | Expr::Call(base, parts) => *base == id || parts.contains(&id),
        Expr::Struct(parts) => parts.contains(&Some(id)),
        _ => false,
    }
}

/// First of the most common types that has this field.
fn with_field(name: &str) -> Option<Ty> {
    let types = [BaseType::Point, BaseType::Trsf, BaseType::Joint, BaseType::Mdesc, BaseType::Config, BaseType::Frame];
    let arm = Some(Arm::SixAxis);
    types.into_iter().find(|ty| fields(*ty, arm).iter().any(|field| field.name == name)).map(Ty::of)
}
