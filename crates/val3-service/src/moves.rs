//! Moves of clients: conversion of move descriptors to move requests, and of results to answers.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::Joints;
use val3_lang::ports::MoveRequest;
use val3_lang::values::MdescValue;
use val3_machine::arm::{ClientCommand, ClientMoveError};
use val3_moves::{BlendKind, Manner, MovePath, MoveTarget};
use val3_soap::v3::{BlendType, Matrix, MotionAnswer, MotionDescription, MotionResult, MoveAnswer, MoveType};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::inferred::{BLOCKED_MOVE, NO_MOVE, UNLIMITED_SPEED, origin_of_positions};
use crate::kinematics::{pose, requested};
use crate::units::MM;

/// Coordinate limit for tools, frames and destinations, in mm: 1 km. No arm reaches larger coordinates.
const MOST_COORDINATE: f64 = 1e6;

/// A position in a request.
#[derive(Clone, Copy)]
pub(crate) struct PositionElement<'a> {
    /// Name of the element, for messages.
    pub(crate) name: &'a str,
    pub(crate) matrix: &'a Matrix,
}

/// Frames that a move descriptor selects.
pub(crate) struct MoveFrames {
    /// Tool centre point on the flange.
    tool: IsometryMatrix3<f64>,
    /// Pose in `world` to which the positions of the request are relative.
    origin: IsometryMatrix3<f64>,
}

impl MoveFrames {
    /// Frames of a move that begins at `flange`, the pose of the flange at the end of the previous move.
    fn new(description: &MotionDescription, flange: IsometryMatrix3<f64>) -> Result<Self, String> {
        let (tool, frame) = (valid_pose("tool", &description.tool)?, valid_pose("frame", &description.frame)?);
        Ok(Self { tool, origin: origin_of_positions(description.kind, frame, flange * tool) })
    }

    /// Converts a position in a request to a pose in `world`.
    ///
    /// # Errors
    /// The matrix is no frame.
    pub(crate) fn in_world(&self, position: PositionElement<'_>) -> Result<IsometryMatrix3<f64>, String> {
        Ok(self.origin * valid_pose(position.name, position.matrix)?)
    }
}

impl Context<'_, '_> {
    /// Records a move of a client. `path` returns the path, or the reason why a parameter is invalid.
    ///
    /// # Errors
    /// The robot or the description is invalid. A move that is not possible is a result, not a fault.
    pub(crate) fn record_move(
        &mut self,
        instruction: &'static str,
        robot: i32,
        description: &MotionDescription,
        path: impl FnOnce(&MoveFrames, &Self) -> Result<MovePath, String>,
    ) -> Result<MoveAnswer, SoapFault> {
        self.check_robot(robot)?;
        if description.frequency <= 0.0 {
            return Err(refused(ExceptionCode::InvalidMotDesc, "`freq` must be greater than 0"));
        }
        if let Err(error) = self.target.debugger.controller.check_client_move() {
            return Ok(MoveAnswer { id: NO_MOVE, result: motion_result(&error) });
        }
        let arm = self.target.debugger.controller.arm();
        let frames = MoveFrames::new(description, arm.model().flange(&arm.next_start()));
        let request = frames.and_then(|frames| {
            let path = path(&frames, self)?;
            let (tool, descriptor) = (frames.tool, descriptor(description));
            Ok(MoveRequest { instruction, path, tool, descriptor, manner: Manner::Rigid })
        });
        let controller = self.controller();
        let recorded = match request {
            Ok(request) => controller.record_client_move(request),
            Err(reason) => Err(controller.reject_client_move(instruction, ClientMoveError::Parameter(reason))),
        };
        Ok(match recorded {
            Ok(id) => MoveAnswer { id, result: MotionResult::NoError },
            Err(error) => MoveAnswer { id: NO_MOVE, result: motion_result(&error) },
        })
    }

    /// Records a move to a position, which has a path to this target.
    ///
    /// # Errors
    /// The robot, the description or its configuration is invalid.
    pub(crate) fn record_move_to(
        &mut self,
        instruction: &'static str,
        robot: i32,
        description: &MotionDescription,
        destination: PositionElement<'_>,
        path: impl FnOnce(&MoveFrames, MoveTarget) -> Result<MovePath, String>,
    ) -> Result<MoveAnswer, SoapFault> {
        let configuration = requested(self.controller().arm().model(), &description.config)?;
        self.record_move(instruction, robot, description, |frames, _| {
            path(frames, MoveTarget { pose: frames.in_world(destination)?, configuration })
        })
    }

    /// Destination of a move to joints, in degrees and mm.
    pub(crate) fn destination(&self, joints: &Joints, kind: MoveType) -> Joints {
        match kind {
            MoveType::Absolute => *joints,
            MoveType::Relative => {
                let start = self.target.debugger.controller.arm().next_start();
                let mut sums = start.iter().zip(joints).map(|(start, way)| start + way);
                std::array::from_fn(|_| sums.next().unwrap_or_default())
            }
        }
    }

    /// Executes a command for all moves of clients. `name` is the name of the request.
    pub(crate) fn command_moves(&mut self, command: ClientCommand, name: &'static str) -> MotionAnswer {
        let result = self.controller().command_client_moves(command, name);
        MotionAnswer { result: result.map_or_else(|error| motion_result(&error), |()| MotionResult::NoError) }
    }
}

/// Motion descriptor in per cent, mm/s, degrees/s and mm.
fn descriptor(description: &MotionDescription) -> MdescValue {
    let [vel, accel, decel] = [description.speed, description.acceleration, description.deceleration].map(percent);
    let tvel = (description.translation_speed * MM).min(UNLIMITED_SPEED);
    let rvel = description.rotation_speed.to_degrees().min(UNLIMITED_SPEED);
    let blend = match description.blend {
        BlendType::Off => BlendKind::Off,
        BlendType::Joint => BlendKind::Joint,
        BlendType::Cartesian => BlendKind::Cartesian,
    };
    let (leave, reach) = (description.leave * MM, description.reach * MM);
    MdescValue { accel, vel, decel, tvel, rvel, blend, leave, reach }
}

fn percent(fraction: f64) -> f64 {
    fraction * 100.0
}

/// Converts a matrix to a pose in mm. `name` is the element's name for messages.
fn valid_pose(name: &str, matrix: &Matrix) -> Result<IsometryMatrix3<f64>, String> {
    let pose = pose(matrix).ok_or_else(|| format!("`{name}` is no right-handed frame"))?;
    if pose.translation.vector.amax() > MOST_COORDINATE {
        return Err(format!("`{name}` has a coordinate of more than {} m", MOST_COORDINATE / MM));
    }
    Ok(pose)
}

fn motion_result(error: &ClientMoveError) -> MotionResult {
    match error {
        ClientMoveError::NotRemote | ClientMoveError::NoPower => MotionResult::NotReady,
        ClientMoveError::OwnedByPrograms => MotionResult::Misuse,
        ClientMoveError::NotReset | ClientMoveError::Full => BLOCKED_MOVE,
        ClientMoveError::Descriptor(_) | ClientMoveError::Impossible(_) | ClientMoveError::Parameter(_) => {
            MotionResult::WrongParameter
        }
    }
}
