namespace RayTracer.Desktop.ViewModels;

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
