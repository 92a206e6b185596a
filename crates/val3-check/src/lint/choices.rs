//! Enumerators in fields of positions and motion descriptors: `mFast.blend`, `pPick.config.elbow`.

use std::rc::Rc;

use rustc_hash::FxHashMap;
use smol_str::{SmolStr, format_smolstr};
use val3_analysis::body::{Constant, Expr, ExprId};
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_analysis::flow::{Facts, FlowNode, FlowNodeId, PointKind, forward};
use val3_analysis::items::initial::{Initial, initial};
use val3_lang::enumerations::{self, Enumerator};
use val3_lang::motion::keeps_configuration;
use val3_lang::types::{AttributeValue, BaseType, attributes};

use super::ProgramView;

/// Fields whose value is certain, spelled as in the code but without indexes: `l_mFast.blend`.
pub(crate) type Choices = FxHashMap<SmolStr, Choice>;

/// An enumerated field's certain value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Choice {
    pub(crate) value: &'static Enumerator,
    /// Whether the value differs from the default of a variable.
    pub(crate) is_chosen: bool,
}

impl ProgramView<'_> {
    /// Certain values, before each flow node, of fields that the program itself sets.
    pub(crate) fn choices(&self) -> Facts<Rc<Choices>> {
        let start = self.header.locals.iter().flat_map(|local| {
            let ty = BaseType::from_file_name(&local.type_name).filter(|_| local.sizes == [1]);
            let fields = ty.into_iter().flat_map(|(ty, _)| enumerated(ty));
            let default = |ty| Some(Choice { value: enumerations::values(ty).next()?, is_chosen: false });
            fields.filter_map(move |(field, ty)| Some((join(&local.name, field), default(ty)?)))
        });
        let step = |id: FlowNodeId, point: &FlowNode, before: &Rc<Choices>| self.choices_after(id, point, before);
        forward(self.flow(), Rc::new(start.collect()), step, |known, other| {
            let differs = |(field, value): (&SmolStr, &Choice)| other.get(field) != Some(value);
            let news = !Rc::ptr_eq(known, other) && known.iter().any(differs);
            if news {
                Rc::make_mut(known).retain(|field, value| other.get(field) == Some(value));
            }
            news
        })
    }

    /// Value of `field` of the variable `id`, if it is certain: set by this program, or stated in the data file of a
    /// variable that no program ever changes.
    pub(crate) fn choice(&self, known: &Choices, id: ExprId, field: &str) -> Option<Choice> {
        let id = self.moved_from(id);
        let set = self.path(id).and_then(|path| known.get(&join(&path, field)).copied());
        set.or_else(|| {
            let initial = self.initial(id)?;
            let (_, value) = initial.choices.iter().find(|(name, _)| *name == field)?;
            Some(Choice { value, is_chosen: initial.needs_corner })
        })
    }

    /// Point from which a computed point copies its configuration.
    fn moved_from(&self, id: ExprId) -> ExprId {
        let id = self.body.without_parentheses(id);
        let call = self.call_of(id).filter(|call| keeps_configuration(call.instruction));
        call.and_then(|call| call.args.first().copied()).map_or(id, |point| self.moved_from(point))
    }

    /// Value of a global variable during the entire run of the application: the value in its data file, if no program
    /// changes it.
    pub(crate) fn initial(&self, id: ExprId) -> Option<&Initial> {
        self.written(id).filter(|(name, _)| self.is_constant(name)).map(|(_, initial)| initial)
    }

    /// Name of a global variable, and its value in the data file.
    pub(super) fn written(&self, id: ExprId) -> Option<(&SmolStr, &Initial)> {
        let id = self.body.without_parentheses(id);
        let (name, key) = match self.body.expr(id) {
            Expr::Index(base, keys) => (*base, self.key(keys)?),
            _ => (id, SmolStr::new_static("0")),
        };
        let (Expr::Name(name), RootVariable::Data(_)) = (self.body.expr(name), self.effects.root(id)?) else {
            return None;
        };
        let item = self.items.data.get(name)?;
        Some((name, initial(self.db, item.file).get(name)?.get(&key)?))
    }

    /// Whether no program of an application without faults changes the data. Other applications cannot access data of
    /// an application, unlike data of a library.
    pub(crate) fn is_constant(&self, name: &str) -> bool {
        self.is_closed(name) && !self.application().uses_of(name).may_write()
    }

    /// Whether another program may write the data.
    pub(crate) fn may_change_elsewhere(&self, name: &str) -> bool {
        let users = self.application().users.get(name).into_iter().flatten();
        let is_private = self.items.data.get(name).is_some_and(|item| !item.decl.public);
        !is_private || users.filter(|(user, _)| user != self.name()).any(|(_, uses)| uses.may_write())
    }

    /// Whether the programs that may change the data are known: the programs of an application without faults.
    pub(super) fn is_closed(&self, name: &str) -> bool {
        let application = self.application();
        let is_private = self.items.data.get(name).is_some_and(|item| !item.decl.public);
        application.sound && (is_private || !application.tasks.is_empty())
    }

    fn key(&self, keys: &[ExprId]) -> Option<SmolStr> {
        let keys: Option<Vec<String>> = keys
            .iter()
            .map(|key| match self.body.constant(*key)? {
                Constant::Number(number) => Some(number.to_string()),
                Constant::String(text) => Some(text.to_string()),
                Constant::Bool(_) => None,
            })
            .collect();
        Some(keys?.join(",").into())
    }

    fn choices_after(&self, id: FlowNodeId, point: &FlowNode, before: &Rc<Choices>) -> Rc<Choices> {
        let writes = self.effects.at(id).iter().any(|access| access.kind != AccessKind::Read);
        if !writes && !matches!(point.kind, PointKind::Call(_)) {
            return before.clone();
        }
        let mut known = Choices::clone(before);
        if let PointKind::Call(_) = point.kind {
            known.retain(|field, _| self.is_own(field));
        }
        for access in self.effects.at(id).iter().filter(|access| access.kind != AccessKind::Read) {
            let written = self.path_without_indexes(access.id);
            known.retain(|field, _| !is_part(field, &written) && !is_part(&written, field));
        }
        if let PointKind::Assign { target, value } = point.kind
            && let Some(target) = self.path(target)
        {
            known.extend(self.assigned(before, &target, value));
        }
        Rc::new(known)
    }

    /// Certain values after `target=value`.
    fn assigned(&self, before: &Choices, target: &SmolStr, value: ExprId) -> Vec<(SmolStr, Choice)> {
        let Some(ty) = self.inference.ty(value).base.builtin() else { return Vec::new() };
        if ty.is_enumeration() {
            let value = match self.body.expr(self.body.without_parentheses(value)) {
                Expr::Name(name) => enumerations::find(name)
                    .filter(|found| found.ty == ty)
                    .map(|value| Choice { value, is_chosen: true }),
                Expr::Field { base, field, .. } => self.choice(before, *base, field),
                _ => None,
            };
            return value.map(|value| (target.clone(), value)).into_iter().collect();
        }
        let copied = |(field, _): (&str, BaseType)| Some((join(target, field), self.choice(before, value, field)?));
        enumerated(ty).filter_map(copied).collect()
    }

    /// Variable or field as spelled in the code, if it has no index.
    fn path(&self, id: ExprId) -> Option<SmolStr> {
        let has_index = self.body.within(id).any(|part| matches!(self.body.expr(part), Expr::Index(..)));
        (!has_index && self.effects.root(id).is_some()).then(|| self.path_without_indexes(id))
    }

    /// Variable or field without its indexes.
    pub(crate) fn path_without_indexes(&self, id: ExprId) -> SmolStr {
        match self.body.expr(id) {
            Expr::Name(name) => name.clone(),
            Expr::Path { library, item } => format_smolstr!("{library}:{item}"),
            Expr::Field { base, field, .. } => join(&self.path_without_indexes(*base), field),
            Expr::Index(base, _) | Expr::Paren(base) => self.path_without_indexes(*base),
            _ => SmolStr::default(),
        }
    }

    /// Whether the field belongs to a local variable, which no other program can change.
    fn is_own(&self, field: &str) -> bool {
        let name = field.split('.').next().unwrap_or(field);
        self.header.locals.iter().any(|local| local.name == name)
    }
}

/// Enumerated fields of a type, as spelled in the code after the variable.
pub(super) fn enumerated(ty: BaseType) -> impl Iterator<Item = (&'static str, BaseType)> {
    attributes(ty, None).iter().filter_map(|attribute| match attribute.value {
        AttributeValue::Choice(choice) => Some((attribute.field, choice)),
        _ => None,
    })
}

fn join(base: &str, field: &str) -> SmolStr {
    format_smolstr!("{base}.{field}")
}

/// Whether `part` is `whole` or a field of it.
fn is_part(part: &str, whole: &str) -> bool {
    part.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}
