namespace RayTracer.Desktop.ViewModels;

/// <summary>A rectangle on the screen.</summary>
internal sealed record Box(double Left, double Top, double Width, double Height)
{
    /// <summary>One that is not to be seen.</summary>
    public static Box None { get; } = new(0, 0, 0, 0);

    /// <summary>Whether it is to be seen.</summary>
    public bool IsVisible => Width > 0 && Height > 0;
}
