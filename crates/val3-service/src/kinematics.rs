//! Matrices and configurations of the interface.

use nalgebra::{Matrix3, Rotation3, Translation3, Vector3};
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, ConfigurationRequest, Elbow, Joints, RequestedConfiguration, Shoulder, Wrist};
use val3_soap::v3::{self, AnthroConfig, ArmConfig, Matrix, PositiveNegative, ScaraConfig};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::units::{MM, joints_from_si};

/// Tolerance for axis lengths, and for right angles between axes as a sine. It accepts matrices that are rounded to three
/// decimals.
const DEVIATION: f64 = 1e-3;

impl Context<'_, '_> {
    /// Converts joints of a request.
    ///
    /// # Errors
    /// The number of joints is wrong.
    pub(crate) fn joints(&mut self, joints: &[f64]) -> Result<Joints, SoapFault> {
        let arm = self.controller().arm().model();
        joints_from_si(joints, arm)
            .ok_or_else(|| refused(ExceptionCode::InvalidNumberOfAxis, &format!("the arm has {} joints", arm.axes())))
    }
}

/// Converts a pose in mm.
pub(crate) fn matrix(pose: &IsometryMatrix3<f64>) -> Matrix {
    let rotation = pose.rotation.matrix();
    let [n, o, a]: [[f64; 3]; 3] = [0, 1, 2].map(|column| rotation.column(column).into_owned().into());
    let [px, py, pz]: [f64; 3] = (pose.translation.vector / MM).into();
    let ([nx, ny, nz], [ox, oy, oz], [ax, ay, az]) = (n, o, a);
    Matrix { nx, ny, nz, ox, oy, oz, ax, ay, az, px, py, pz }
}

/// Converts a matrix to a pose in mm; `None` if its axes are no right-handed frame.
pub(crate) fn pose(matrix: &Matrix) -> Option<IsometryMatrix3<f64>> {
    let n = Vector3::new(matrix.nx, matrix.ny, matrix.nz);
    let o = Vector3::new(matrix.ox, matrix.oy, matrix.oz);
    let a = Vector3::new(matrix.ax, matrix.ay, matrix.az);
    let x = n.try_normalize(1.0 - DEVIATION)?;
    let y = (o - x * x.dot(&o)).try_normalize(1.0 - DEVIATION)?;
    let z = x.cross(&y);
    let deviations = [n - x, o - y, a - z].map(|difference| difference.norm());
    if deviations.iter().any(|deviation| *deviation > 2.0 * DEVIATION) {
        return None;
    }
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, z]));
    let translation = Translation3::new(matrix.px * MM, matrix.py * MM, matrix.pz * MM);
    Some(IsometryMatrix3::from_parts(translation, rotation))
}

/// Configuration of joints.
pub(crate) fn config(arm: &Arm, joints: &Joints) -> ArmConfig {
    let configuration = arm.configuration(joints);
    let shoulder = match configuration.shoulder {
        Shoulder::Lefty => v3::Shoulder::Lefty,
        Shoulder::Righty => v3::Shoulder::Righty,
    };
    if arm.is_scara() {
        return ArmConfig::Scara(ScaraConfig { shoulder });
    }
    let sign = |is_positive| if is_positive { PositiveNegative::Positive } else { PositiveNegative::Negative };
    ArmConfig::Anthro(AnthroConfig {
        shoulder,
        elbow: sign(configuration.elbow == Elbow::Positive),
        wrist: sign(configuration.wrist == Wrist::Positive),
    })
}

/// Converts the configuration of a request.
///
/// # Errors
/// The configuration belongs to another kind of arm.
pub(crate) fn requested(arm: &Arm, config: &ArmConfig) -> Result<RequestedConfiguration, SoapFault> {
    match config {
        ArmConfig::Anthro(anthro) if !arm.is_scara() => Ok(RequestedConfiguration {
            shoulder: shoulder(anthro.shoulder),
            elbow: signed(anthro.elbow, Elbow::Positive, Elbow::Negative),
            wrist: signed(anthro.wrist, Wrist::Positive, Wrist::Negative),
        }),
        ArmConfig::Scara(scara) if arm.is_scara() => {
            Ok(RequestedConfiguration { shoulder: shoulder(scara.shoulder), ..RequestedConfiguration::FREE })
        }
        _ => Err(refused(ExceptionCode::InvalidConfig, "the configuration belongs to another kind of arm")),
    }
}

fn shoulder(requested: v3::Shoulder) -> ConfigurationRequest<Shoulder> {
    match requested {
        v3::Shoulder::Same => ConfigurationRequest::Same,
        v3::Shoulder::Lefty => ConfigurationRequest::Exactly(Shoulder::Lefty),
        v3::Shoulder::Righty => ConfigurationRequest::Exactly(Shoulder::Righty),
        v3::Shoulder::Free => ConfigurationRequest::Free,
    }
}

fn signed<T>(requested: PositiveNegative, positive: T, negative: T) -> ConfigurationRequest<T> {
    match requested {
        PositiveNegative::Same => ConfigurationRequest::Same,
        PositiveNegative::Positive => ConfigurationRequest::Exactly(positive),
        PositiveNegative::Negative => ConfigurationRequest::Exactly(negative),
        PositiveNegative::Free => ConfigurationRequest::Free,
    }
}
