using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Pointer, wheel and keys in the picture.</summary>
internal sealed partial class ViewportViewModel
{
    private const double ClickDistance = 4;
    private const double KeyStep = 0.04;
    private const double TranslateStep = 0.03;
    private const double WheelStep = 0.1;
    private Action<Spot>? _drag;
    private Action? _release;
    private Spot _start;
    private Spot _last;
    private bool _isMoved;
    private bool _isClick;

    /// <summary>Takes the pixel to inspect.</summary>
    public Action<Spot> Inspect { get; set; } = _ => { };

    /// <summary>Called when a thing was selected in the picture.</summary>
    public Action Selected { get; set; } = () => { };

    /// <summary>A button is pressed.</summary>
    /// <param name="at">The point on the stage.</param>
    /// <param name="button">Which.</param>
    /// <param name="keys">The keys that are held.</param>
    public void Press(Spot at, PointerButton button, HeldKeys keys)
    {
        (_start, _last, _isMoved, _isClick, _drag, _release) = (at, at, false, button == PointerButton.Main, null, null);
        if (button == PointerButton.Main && keys.HasFlag(HeldKeys.Space))
        {
            _drag = to => Stage = Stage.ShiftedBy(to.X - _last.X, to.Y - _last.Y);
        }
        else if (button == PointerButton.Main && keys == HeldKeys.None && Gizmo.Grab(at, Stage.ToPicture(at)))
        {
            _isClick = false;
            _drag = to => Gizmo.Drag(Stage.ToPicture(to));
            _release = Gizmo.Drop;
        }
        else if (button == PointerButton.Main && keys == HeldKeys.None && Tool == Tool.Region)
        {
            DrawRegion(Stage.ToPicture(at));
        }
        else
        {
            DragCamera(button == PointerButton.Second ? CameraMoveKind.Rotate
                : button == PointerButton.Middle || keys.HasFlag(HeldKeys.Shift) ? CameraMoveKind.Pan : CameraMoveKind.Orbit);
        }
    }

    /// <summary>The pointer moves while a button is pressed.</summary>
    public void Move(Spot to)
    {
        _isMoved |= to.DistanceTo(_start) > ClickDistance;
        if (_isMoved && _drag is not null)
        {
            _drag(to);
            _last = to;
        }
    }

    /// <summary>The button is let go.</summary>
    public void Release(Spot at)
    {
        bool isClick = _isClick && !_isMoved && _drag is not null;
        _drag = null;
        _release?.Invoke();
        _release = null;
        if (isClick && Stage.PixelAt(at) is { } pixel)
        {
            Click(pixel);
        }
    }

    /// <summary>The wheel is turned.</summary>
    /// <param name="at">The point on the stage.</param>
    /// <param name="steps">Steps away from the user.</param>
    /// <param name="keys">The keys that are held.</param>
    public void Turn(Spot at, double steps, HeldKeys keys)
    {
        if (keys.HasFlag(HeldKeys.Mod))
        {
            // Two steps double it.
            Stage = Stage.ZoomedBy(steps >= 0 ? 1 + (0.41421356 * steps) : 1 / (1 - (0.41421356 * steps)), at);
        }
        else
        {
            Camera.Burst(keys.HasFlag(HeldKeys.Alt) ? CameraMoveKind.Zoom : CameraMoveKind.Dolly, 0, -steps * WheelStep);
        }
    }

    /// <summary>A key is pressed while the picture has the focus; false where it moves nothing.</summary>
    /// <param name="key">The key, as browsers call it.</param>
    /// <param name="keys">The keys that are held.</param>
    public bool Key(string key, HeldKeys keys)
    {
        if (keys.HasFlag(HeldKeys.Mod) || keys.HasFlag(HeldKeys.Alt))
        {
            return false;
        }

        CameraMoveKind around = keys.HasFlag(HeldKeys.Shift) ? CameraMoveKind.Pan : CameraMoveKind.Orbit;
        (CameraMoveKind Kind, double X, double Y, double Z)? move = key switch
        {
            "ArrowLeft" => (around, -KeyStep, 0, 0),
            "ArrowRight" => (around, KeyStep, 0, 0),
            "ArrowUp" => (around, 0, -KeyStep, 0),
            "ArrowDown" => (around, 0, KeyStep, 0),
            "+" or "=" => (CameraMoveKind.Dolly, 0, -KeyStep, 0),
            "-" => (CameraMoveKind.Dolly, 0, KeyStep, 0),
            "w" => (CameraMoveKind.Translate, 0, 0, TranslateStep),
            "s" => (CameraMoveKind.Translate, 0, 0, -TranslateStep),
            "a" => (CameraMoveKind.Translate, -TranslateStep, 0, 0),
            "d" => (CameraMoveKind.Translate, TranslateStep, 0, 0),
            "e" => (CameraMoveKind.Translate, 0, -TranslateStep, 0),
            "q" => (CameraMoveKind.Translate, 0, TranslateStep, 0),
            _ => null,
        };
        if (move is { } m)
        {
            Camera.Burst(m.Kind, m.X, m.Y, m.Z);
        }

        return move is not null;
    }

    private void DragCamera(CameraMoveKind kind)
    {
        string gesture = Gesture.New();
        double height = Math.Max(1, Place.Height);
        _drag = to => Camera.Move(kind, gesture, (to.X - _last.X) / height, (to.Y - _last.Y) / height);
        _release = () =>
        {
            if (_isMoved)
            {
                Camera.End(kind, gesture);
            }
        };
    }

    private void DrawRegion(Spot start)
    {
        _isClick = false;
        _drag = to =>
        {
            (_regionStart, _regionEnd) = (start, Stage.ToPicture(to));
            OnPropertyChanged(nameof(Region));
        };
        _release = () =>
        {
            if (_regionStart is not null && Stage.Between(start, _regionEnd) is { } region)
            {
                Tool = Tool.Select;
                dispatcher.Do(s => s.View.Change(v => v with { Region = region }));
            }

            _regionStart = null;
            OnPropertyChanged(nameof(Region));
        };
    }

    private void Click(Spot pixel)
    {
        (float x, float y) = ((float)pixel.X, (float)pixel.Y);
        if (Tool == Tool.Focus)
        {
            dispatcher.Do(s => s.Camera.Focus(x, y));
        }
        else if (Tool == Tool.Inspect)
        {
            Inspect(pixel);
        }
        else
        {
            _ = dispatcher.Attempt(async () =>
            {
                string? pointer = await dispatcher.Ask(s =>
                {
                    string? found = Picking.Selectable(s.Document, s.View.RequireShown(), x, y).Pointer;
                    s.Selection.Select(found);
                    return found;
                });
                if (pointer is not null)
                {
                    Selected();
                }
            });
        }
    }
}

/// <summary>The keys that change what a pointer or a wheel does.</summary>
[Flags]
internal enum HeldKeys
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Shift.</summary>
    Shift = 1,

    /// <summary>Ctrl, or Command on a Mac.</summary>
    Mod = 2,

    /// <summary>Alt.</summary>
    Alt = 4,

    /// <summary>The space bar.</summary>
    Space = 8,
}

/// <summary>The button of a pointer.</summary>
internal enum PointerButton
{
    /// <summary>The left one, a finger, a pen's tip.</summary>
    Main,

    /// <summary>The wheel.</summary>
    Middle,

    /// <summary>The right one.</summary>
    Second,
}

/// <summary>The tools of the pointer in the picture.</summary>
internal enum Tool
{
    /// <summary>Orbits, and selects.</summary>
    Select,

    /// <summary>Moves the selected shape by its handles.</summary>
    Move,

    /// <summary>Turns it.</summary>
    Rotate,

    /// <summary>Changes its size.</summary>
    Scale,

    /// <summary>Focuses on what is clicked.</summary>
    Focus,

    /// <summary>Looks into the pixel that is clicked.</summary>
    Inspect,

    /// <summary>Draws the part of the picture that is rendered.</summary>
    Region,
}
