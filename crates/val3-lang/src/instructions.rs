//! Instruction catalogue: all instructions with their forms and pages.
//!
//! An instruction is one file in its family's folder, and one line here.

use std::sync::LazyLock;

use rustc_hash::FxHashMap;

use crate::declare::catalogue;
use crate::instruction::{Family, Instruction, Overload};

catalogue! {
    variables {
        size,
        is_defined,
        insert,
        delete,
        get_data,
        append,
        resize,
        first,
        next,
        last,
        prev,
    }
    numbers {
        sin,
        asin,
        cos,
        acos,
        tan,
        atan,
        abs,
        sqrt,
        exp,
        power,
        ln,
        log,
        round_up,
        round_down,
        round,
        min,
        max,
        limit,
        sel,
    }
    bits {
        b_not,
        b_and,
        b_or,
        b_xor,
        to_binary,
        from_binary,
    }
    strings {
        to_string,
        to_num,
        chr,
        asc,
        left,
        right,
        mid,
        replace,
        find,
        len,
    }
    io {
        dio_link,
        dio_get,
        dio_set,
        io_status,
        aio_link,
        aio_get,
        aio_set,
        sio_link,
        clear_buffer,
        sio_get,
        sio_set,
        sio_ctrl,
    }
    screen {
        user_page,
        gotoxy,
        cls,
        set_text_mode,
        get_display_len,
        put,
        putln,
        title,
        get,
        get_key,
        is_key_pressed,
        pop_up_msg,
        log_msg,
        get_profile,
        set_profile,
        get_language,
        set_language,
        get_date,
    }
    tasks {
        task_suspend,
        task_resume,
        task_kill,
        set_mutex,
        help,
        task_status,
        task_create,
        task_create_sync,
        wait,
        delay,
        clock,
        watch,
    }
    libraries {
        lib_load,
        lib_save,
        lib_delete,
        lib_path,
        lib_list,
        lib_exist,
    }
    controller {
        disable_power,
        enable_power,
        is_powered,
        is_calibrated,
        working_mode,
        es_status,
        safety_fault,
        io_bus_status,
        get_monitor_speed,
        set_monitor_speed,
        get_version,
    }
    geometry {
        herej,
        is_in_range,
        set_latch,
        get_latch,
        distance,
        interpolate_l,
        interpolate_c,
        align,
        set_frame,
        position,
        link,
        open,
        close,
        compose,
        appro,
        here,
        joint_to_point,
        point_to_joint,
        config,
    }
    motion {
        movej,
        movel,
        movec,
        stop_move,
        reset_motion,
        restart_move,
        wait_end_move,
        is_empty,
        is_settled,
        auto_connect_move,
        get_speed,
        get_position_err,
        get_joint_force,
        get_move_id,
        set_move_id,
    }
    options {
        movejf,
        movelf,
        is_compliant,
        alter_movej,
        alter_movel,
        alter_movec,
        alter_begin,
        alter_end,
        alter,
        alter_stop_time,
        get_licence,
        get_dh,
        get_default_dh,
        set_dh,
        reset_turn,
    }
    additions {
        user_page_set,
        user_page_alert,
        user_page_confirm,
        user_page_prompt,
        opcua_export,
        set_safety_restart,
        get_jnt_ref,
        get_safe_ref_status,
        wake_up_robot,
        has_cpu_ext_power_supply,
        set_payload,
        speed_scale,
    }
    add_ons {
        file_open,
        file_close,
        file_get,
        file_set,
        file_exists,
        copy,
        delete,
        rename,
        exec,
        compile,
        dins,
        ddel,
        jog_context,
        jog_page,
        lib_open,
        lib_close,
        task_call_stack,
        get_name,
        circle_find,
        get_free_space,
        get_power_count,
        get_state,
        set_arm_limits,
        get_pos_fbk,
        get_jnt_fbk,
        get_jnt_speed_cmd,
        get_jnt_speed_fbk,
        rot_angle,
        get_rot,
        set_rot,
        get_cycle_time,
        get_boxcar_delay,
        motion_state,
        compute_jnt_frc,
        external_force,
        vel_frame,
        vel_tool,
        vel_joint,
        set_vel_cmd,
        rec_add,
        rec_clean,
        rec_start,
        rec_stop,
        rec_store,
    }
}

static BY_NAME: LazyLock<FxHashMap<&'static str, &'static Instruction>> =
    LazyLock::new(|| CATALOGUE.iter().map(|instruction| (instruction.name, *instruction)).collect());

/// All instructions, by family in the manual's order.
#[must_use]
pub fn all() -> &'static [&'static Instruction] {
    CATALOGUE
}

/// Finds an instruction by name, including `$` for instructions of add-ons.
#[must_use]
pub fn find(name: &str) -> Option<&'static Instruction> {
    BY_NAME.get(name).copied()
}

/// Loads a library under an identifier. The analysis compares the library with the identifier's interface (6.7).
pub const LIB_LOAD: &str = "libLoad";

/// Saves a library, under its path or another one, where `libLoad` finds it (6.7).
pub const LIB_SAVE: &str = "libSave";

/// Instructions that name a task of the same application or library (5.10).
pub const ON_TASKS: [&str; 4] = ["taskSuspend", "taskResume", TASK_KILL, TASK_STATUS];

/// Ends a task and releases its name (5.10).
pub const TASK_KILL: &str = "taskKill";

/// Returns the state of a task: a state number, or the number of a run-time error (5.10).
pub const TASK_STATUS: &str = "taskStatus";

/// Explains a run-time error by number (5.10).
pub const HELP: &str = "help";

/// Instructions that return a key code (4.3).
pub const READ_KEYS: [&str; 2] = ["get", GET_KEY];

/// The last argument is a key code (4.3).
pub const IS_KEY_PRESSED: &str = "isKeyPressed";

/// Reads data whose name is a string (2.5.4); the named data count as used.
pub const GET_DATA: &str = "getData";

/// Changes an attribute of a user page element (s8); page and id are strings.
pub const USER_PAGE_SET: &str = "userPageSet";

/// Returns whether a library has an item (6.7); programs check it before they use the item.
pub const LIB_EXIST: &str = "libExist";

/// Returns the time (5.10); a loop that reads the clock limits its own speed.
pub const CLOCK: &str = "clock";

/// Waits until the arm has executed every recorded move (10.6).
pub const WAIT_END_MOVE: &str = "waitEndMove";

/// Waits until a condition holds, while other tasks continue (5.10).
pub const WAIT: &str = "wait";

/// As [`WAIT`], with a timeout; returns whether the condition held (5.10).
pub const WATCH: &str = "watch";

/// Waits for a time while other tasks continue; with 0, until their turns are over (5.10).
pub const DELAY: &str = "delay";

/// Number of characters in a string (3.4.3).
pub const LEN: &str = "len";

/// Changes its first argument's father, although the manual does not mark it as passed by reference (9.4.4, 9.5.4,
/// 9.6.3).
pub const LINK: &str = "link";

/// Returns whether a variable or element exists (2.5.4); programs check it before they use the variable.
pub const IS_DEFINED: &str = "isDefined";

/// Returns the current move and its progress (10.6), a number that increases in steps of any size.
pub const GET_MOVE_ID: &str = "getMoveId";

/// Returns the last key that was pressed since the previous call, or -1 (4.3).
pub const GET_KEY: &str = "getKey";

/// Arms the latch of the arm's position (9.2.3).
pub const SET_LATCH: &str = "setLatch";

/// Reads the latched position (9.2.3); returns the previous position until the latch is armed.
pub const GET_LATCH: &str = "getLatch";

/// Waits for a shared flag and sets it, in one line (5.9).
pub const SET_MUTEX: &str = "setMutex";

/// Writes a number in binary to an array of outputs (3.5.3).
pub const DIO_SET: &str = "dioSet";

/// Writes numerical outputs.
pub const AIO_SET: &str = "aioSet";

/// Encodes numbers as bytes (3.3.3). Arguments: values, number of values, format, bytes.
pub const TO_BINARY: &str = "toBinary";

/// Decodes numbers from bytes (3.3.3). Arguments: bytes, number of bytes, format, values.
pub const FROM_BINARY: &str = "fromBinary";

/// Changes a parameter of a serial line or socket (3.7.3).
pub const SIO_CTRL: &str = "sioCtrl";

/// Changes one array dimension (2.5.5). Arguments: array, dimension, size.
pub const RESIZE: &str = "resize";

/// Returns an array's size.
pub const SIZE: &str = "size";

/// Cancels the recorded moves.
pub const RESET_MOTION: &str = "resetMotion";

/// Switches the power of the arm off.
pub const DISABLE_POWER: &str = "disablePower";

/// Records a circular move.
pub const MOVEC: &str = "movec";

/// Records a circular move that a program may alter.
pub const ALTER_MOVEC: &str = "alterMovec";

/// Computes a frame from three points.
pub const SET_FRAME: &str = "setFrame";

/// Sets the title of a user page.
pub const TITLE: &str = "title";

/// Instructions that write the output of a tool.
pub const ON_GRIPPERS: [&str; 2] = ["open", "close"];

/// Raises a number to a power (3.2.3). Arguments: base, exponent.
pub const POWER: &str = "power";

/// Instructions that change array sizes (2.5.4, 2.5.5). They reject local arrays.
const RESIZING: [&str; 4] = ["insert", "delete", "append", RESIZE];

/// Whether the instruction changes its array argument's size.
#[must_use]
pub fn resizes(name: &str) -> bool {
    RESIZING.contains(&name)
}

/// Whether the instruction may change the size of a container argument: [`resizes`], or it enlarges a global array for
/// its result (6.7, 8.1). The effect of add-on instructions is unknown.
#[must_use]
pub fn may_resize(instruction: &Instruction) -> bool {
    resizes(instruction.name)
        || matches!(instruction.name, "libList" | "ioBusStatus")
        || matches!(instruction.family, Family::AddOns | Family::Additions)
}

/// Whether the call shows an HTML page (s8), which accesses data and programs of the application by name.
#[must_use]
pub fn shows_named_page(instruction: &Instruction, form: &Overload) -> bool {
    instruction.name == "userPage" && form.since.is_some()
}

/// Whether the instruction inserts or removes elements of a collection by key (2.5.4). Other instructions that change
/// sizes only accept arrays.
#[must_use]
pub fn resizes_collections(name: &str) -> bool {
    matches!(name, "insert" | "delete")
}

/// Whether the key in the argument need not exist (2.5.4, 2.5.6).
#[must_use]
pub fn takes_any_key(name: &str) -> bool {
    matches!(name, IS_DEFINED | "next" | "prev")
}

/// Whether the instruction returns a point in its argument's frame (9.6.3).
#[must_use]
pub fn gives_point_in_frame(name: &str) -> bool {
    matches!(name, "here" | "jointToPoint")
}

/// Whether the instruction also changes the size of arrays with two or three dimensions (2.5.5).
#[must_use]
pub fn resizes_every_array(name: &str) -> bool {
    name == RESIZE
}

#[cfg(test)]
mod tests {
    use super::{CATALOGUE, DELAY, LINK, TASK_STATUS, WAIT, find};
    use crate::instruction::Availability;
    use crate::keywords::is_task_creation;

    /// Whether the compiler converts the instruction to operations, because its arguments are evaluated repeatedly or
    /// are a call.
    fn is_compiled(name: &str) -> bool {
        is_task_creation(name) || [WAIT, "watch"].contains(&name)
    }

    fn lacks_handlers(name: &str) -> bool {
        find(name).unwrap().overloads.iter().any(|form| form.run.is_none())
    }

    #[test]
    fn no_handler_is_forgotten() {
        let forgotten: Vec<_> = CATALOGUE
            .iter()
            .filter(|row| row.availability == Availability::Manual)
            .map(|row| row.name)
            .filter(|name| is_compiled(name) != lacks_handlers(name))
            .collect();
        assert_eq!(forgotten, [""; 0]);
        assert!([DELAY, TASK_STATUS, LINK].into_iter().all(|name| !lacks_handlers(name)));
    }
}
