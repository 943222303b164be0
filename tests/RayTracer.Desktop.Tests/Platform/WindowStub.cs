using Avalonia;
using Avalonia.Controls;
using Avalonia.Platform;
using Avalonia.Rendering.Composition;

namespace RayTracer.Desktop.Tests;

/// <summary>A window of the stand-in: it has a size, and remembers what is set.</summary>
internal sealed class WindowStub
{
    private readonly Dictionary<string, object?> _values = new(StringComparer.Ordinal);
    private readonly Compositor _compositor = new(null, true);
    private Size _size = new(1280, 800);

    /// <summary>The window as Avalonia has it.</summary>
    public IWindowImpl Window => field ??= Stub.Of<IWindowImpl>((method, args) => Answer(method.Name, args));

    private (bool, object?) Answer(string name, object?[] args)
    {
        switch (name)
        {
            case "get_Compositor": return (true, _compositor);
            case "get_ClientSize": return (true, _size);
            case "get_FrameSize": return (true, (Size?)_size);
            case "get_RenderScaling" or "get_DesktopScaling": return (true, 1.0);
            case "get_MaxAutoSizeHint": return (true, new Size(8000, 8000));
            case "get_Surfaces": return (true, Array.Empty<object>());
            case "TryGetFeature": return (true, null);
            case "Resize":
                _size = (Size)args[0]!;
                (_values.GetValueOrDefault("Resized") as Action<Size, WindowResizeReason>)?.Invoke(_size, WindowResizeReason.User);
                return (true, null);
            case "Dispose":
                (_values.GetValueOrDefault("Closed") as Action)?.Invoke();
                return (true, null);
            case ['s', 'e', 't', '_', ..]:
                _values[name[4..]] = args[0];
                return (true, null);
            case ['g', 'e', 't', '_', ..] when _values.TryGetValue(name[4..], out object? value):
                return (true, value);
            default:
                return (false, null);
        }
    }
}
