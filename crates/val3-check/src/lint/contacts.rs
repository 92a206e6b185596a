//! Contacts of the arm and of what it carries with the things in `cell.toml`.

use val3_analysis::body::ExprId;
use val3_analysis::items::positions::{TaughtPosition, path_of_reference};
use val3_analysis::placement::position;
use val3_analysis::surroundings::scene;
use val3_cell::{Carrier, Contact, Contacts};
use val3_geometry::IsometryMatrix3;
use val3_kinematics::Joints;

use super::nominal::samples;
use super::planned_moves::{PlannedMove, PossibleWay};
use super::reachability::constant_placement;
use super::{ArmReach, FlangeTool, ProgramView, ProjectView};

/// Contacts in the cell of a project, without the things whose frame or tool a program changes.
pub(crate) struct CellContacts<'a> {
    reach: ArmReach<'a>,
    contacts: Contacts,
}

/// A contact at a position in the data files.
pub(crate) struct PositionContact {
    /// Contact with the deepest overlap.
    pub(crate) contact: Contact,
    /// Number of other pairs that touch there.
    pub(crate) others: usize,
    /// Tool at the position; `None` for a joint position.
    pub(crate) tool: Option<FlangeTool>,
}

/// A contact in a move.
pub(crate) struct MoveContact {
    /// Target of the move.
    pub(crate) target: ExprId,
    /// Target of the previous move.
    pub(crate) from: ExprId,
    pub(crate) contact: Contact,
    /// Distance in mm of the tool centre point from its place at the start of the move.
    pub(crate) distance: f64,
}

impl<'a> CellContacts<'a> {
    /// Creates the contacts of a project; `None` without a usable arm or `cell.toml`.
    pub(crate) fn new(view: &'a ProjectView<'a>) -> Option<Self> {
        let scene = scene(view.db, view.project).as_ref()?.scene();
        let reach = ArmReach::new(view)?;
        let places = scene.data().map(|carrier| place(view, carrier)).collect();
        Some(Self { reach, contacts: Contacts::new(scene.clone(), places) })
    }

    /// Contact at a position of the data files, with all tools and in all configurations that may be used there; `None`
    /// if the arm can be there without one, or cannot be there.
    pub(crate) fn at_position(&self, path: &str, position: &TaughtPosition) -> Option<PositionContact> {
        if !self.reach.is_known(path, position) || !self.reach.is_target(path) {
            return None;
        }
        let mut first = None;
        for (tool, joints) in self.reach.possible_joints(path, position)? {
            let mut contacts = self.contacts.at(&joints);
            contacts.sort_by(|one, other| depth(other).total_cmp(&depth(one)));
            let others = contacts.len().saturating_sub(1);
            let contact = contacts.into_iter().next()?;
            first = first.or(Some(PositionContact { contact, others, tool }));
        }
        first
    }

    /// Contacts in the moves of a program between known positions. A move is omitted if one of its possible ways has no
    /// contact. Contacts that begin at its start belong to an earlier move or position, and contacts at a target in the
    /// data files to this position, if [`Self::at_position`] reports it.
    pub(crate) fn in_moves(&self, program: &ProgramView<'_>) -> Vec<MoveContact> {
        let moves = program.planned_moves().moves.iter();
        moves.filter_map(|(call, planned)| self.in_move(program, *call, planned)).collect()
    }

    fn in_move(&self, program: &ProgramView<'_>, call: ExprId, planned: &PlannedMove) -> Option<MoveContact> {
        let (target, from) = (program.target(call)?, program.target(planned.last?)?);
        let is_reported = self.is_reported(program, target);
        let mut first = None;
        for way in &planned.ways {
            let contact = self.on_way(way, &planned.tool, is_reported)?;
            first = first.or_else(|| {
                let distance = self.distance(way, &contact, &planned.tool);
                Some(MoveContact { target, from, contact, distance })
            });
        }
        first
    }

    /// Whether the target of a move is a position of the data files at which the arm has a contact.
    fn is_reported(&self, program: &ProgramView<'_>, target: ExprId) -> bool {
        let path = program.constant_path(program.body.without_parentheses(target));
        let taught = path.as_ref().and_then(|path| Some((path, position(program.db, program.project, path)?)));
        taught.is_some_and(|(path, taught)| self.at_position(path, taught).is_some())
    }

    fn on_way(&self, way: &PossibleWay, tool: &IsometryMatrix3<f64>, is_reported: bool) -> Option<Contact> {
        // Another rule reports a path that the arm cannot follow.
        let path = samples(self.reach.arm, way.start, &way.path, tool).ok()?;
        let mut known = self.contacts.at(&way.start);
        if is_reported {
            known.extend(self.contacts.at(&way.end));
        }
        let is_known = |contact: &Contact| known.iter().any(|known| known.names == contact.names);
        self.contacts.along(&path).into_iter().find(|contact| !is_known(contact))
    }

    fn distance(&self, way: &PossibleWay, contact: &Contact, tool: &IsometryMatrix3<f64>) -> f64 {
        let point = |joints: &Joints| (self.reach.arm.flange(joints) * tool).translation.vector;
        (point(&contact.joints) - point(&way.start)).norm()
    }
}

fn depth(contact: &Contact) -> f64 {
    contact.depth.unwrap_or_default()
}

/// Pose of a frame in `world` or of a tool in `flange`; `None` if a program changes it, or if it belongs to a library.
fn place(view: &ProjectView<'_>, carrier: &Carrier) -> Option<IsometryMatrix3<f64>> {
    match carrier {
        Carrier::Frame(name) | Carrier::Tool(name) => constant_placement(view, &path_of_reference(name)?),
        Carrier::World | Carrier::Flange | Carrier::Link(_) => None,
    }
}
