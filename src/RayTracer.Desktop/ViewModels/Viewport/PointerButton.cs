namespace RayTracer.Desktop.ViewModels;

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
