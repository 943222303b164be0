namespace RayTracer.Desktop.ViewModels;

/// <summary>What the pointer does in the picture.</summary>
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
