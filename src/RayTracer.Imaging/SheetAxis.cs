namespace RayTracer.Imaging;

/// <summary>The values along an axis of a <see cref="ContactSheet"/>.</summary>
/// <param name="Name">What it is called.</param>
/// <param name="Values">What it is at each step.</param>
public sealed record SheetAxis(string Name, IReadOnlyList<string> Values)
{
    /// <summary>An axis of one step without a name.</summary>
    public static SheetAxis None { get; } = new("", [""]);
}
