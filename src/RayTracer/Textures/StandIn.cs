namespace RayTracer.Textures;

/// <summary>The pictures that are shown where one is missing, so that it is seen.</summary>
public static class StandIn
{
    private const int Edge = 16;

    // Of what runs side by side each has its own.
    private static readonly AsyncLocal<bool> s_isError = new();

    /// <summary>Their name in messages.</summary>
    internal const string Words = "magenta checks are shown instead";

    /// <summary>True where what is missing is an error.</summary>
    public static bool IsError
    {
        get => s_isError.Value;
        set => s_isError.Value = value;
    }

    /// <summary>Magenta and black checks, in place of colours.</summary>
    internal static Picture Checks { get; } =
        new(Edge, Edge, [.. Enumerable.Range(0, Edge * Edge).SelectMany(i => ((i / 2) + (i / (2 * Edge))) % 2 == 0 ? new[] { 1f, 0, 1 } : [0, 0, 0])]);

    /// <summary>A half, in place of numbers; as a normal map, it is flat.</summary>
    internal static Picture Numbers { get; } = new(1, 1, [0.5f, 0.5f, 1]);
}
