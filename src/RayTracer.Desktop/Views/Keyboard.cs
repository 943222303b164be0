using Avalonia.Input;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Views;

/// <summary>Keys as the session calls them, which is as browsers do.</summary>
internal static class Keyboard
{
    private static readonly KeyModifiers Mod = OperatingSystem.IsMacOS() ? KeyModifiers.Meta : KeyModifiers.Control;

    /// <summary>The keys that are held besides.</summary>
    public static HeldKeys Held(KeyModifiers modifiers) =>
        (modifiers.HasFlag(Mod) ? HeldKeys.Mod : HeldKeys.None) | (modifiers.HasFlag(KeyModifiers.Shift) ? HeldKeys.Shift : HeldKeys.None) | (modifiers.HasFlag(KeyModifiers.Alt) ? HeldKeys.Alt : HeldKeys.None);

    /// <summary>A key's name.</summary>
    public static string NameOf(Key key, KeyModifiers modifiers) => key switch
    {
        >= Key.A and <= Key.Z => key.ToString().ToLowerInvariant(),
        >= Key.D0 and <= Key.D9 => $"{(char)('0' + (key - Key.D0))}",
        Key.Up or Key.Down or Key.Left or Key.Right => $"Arrow{key}",
        Key.OemQuestion when modifiers.HasFlag(KeyModifiers.Shift) => "?",
        Key.OemPlus or Key.Add => "+",
        Key.OemMinus or Key.Subtract => "-",
        _ => key.ToString(),
    };
}
