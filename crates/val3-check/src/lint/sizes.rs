//! Constant sizes of arrays.

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::effects::RootVariable;
use val3_analysis::guards::FixedArray;
use val3_analysis::resizing::is_resized;

use super::ProgramView;

impl ProgramView<'_> {
    /// Number of elements in a one-dimensional array, from a constant index on, if it is certain: for a local array, or
    /// for private data whose size the application never changes. `None` in a line that another size may skip, because
    /// a condition before it tests the size.
    pub(crate) fn certain_size(&self, id: ExprId) -> Option<u32> {
        let (array, start) = match self.body.expr(id) {
            Expr::Index(array, index) => match **index {
                [index] => (*array, self.body.number(index)?),
                _ => return None,
            },
            _ => (id, 0.0),
        };
        let size = self.declared_size(array)?;
        if self.guards().protect(self.body, id, FixedArray { array, sizes: &[size] }) {
            return None;
        }
        Some(size.saturating_sub(start.round() as u32))
    }

    fn declared_size(&self, array: ExprId) -> Option<u32> {
        let Expr::Name(name) = self.body.expr(array) else { return None };
        let sizes = match self.effects.root(array)? {
            RootVariable::Local(_) => &self.header.locals.iter().find(|local| local.name == *name)?.sizes,
            RootVariable::Data(_) => {
                let data = &self.items.data.get(name)?.decl;
                let changes = data.public || is_resized(self.db, self.project, name);
                Some(&data.sizes).filter(|_| !changes)?
            }
            RootVariable::Param(_) | RootVariable::Item(..) => return None,
        };
        match **sizes {
            [size] => Some(size),
            _ => None,
        }
    }
}
