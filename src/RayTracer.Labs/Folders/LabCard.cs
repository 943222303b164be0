using System.Text.Json;

namespace RayTracer.Labs;

/// <summary>Which lab a folder is, and whose.</summary>
/// <param name="Lab">The number of the lab.</param>
/// <param name="Name">The student's name, which selects the random numbers of the checks.</param>
/// <param name="Version">The version of the program that made it.</param>
/// <param name="Hash">In a hand-in: the hash of the sources.</param>
public sealed record LabCard(int Lab, string Name, string Version, string? Hash = null)
{
    private const int LongestName = 100;

    /// <summary>How it is written and read.</summary>
    internal static JsonSerializerOptions Json { get; } = new() { WriteIndented = true, PropertyNameCaseInsensitive = true, ReadCommentHandling = JsonCommentHandling.Skip };

    /// <summary>Reads one.</summary>
    /// <param name="text">The JSON.</param>
    /// <param name="file">What messages call it.</param>
    /// <exception cref="LabException">It is no such JSON.</exception>
    internal static LabCard Read(string text, string file)
    {
        try
        {
            LabCard? card = JsonSerializer.Deserialize<LabCard>(text, Json);
            return card is { Name: { Length: > 0 and <= LongestName } name } && !name.Any(char.IsControl) && Labs.Lab.Of(card.Lab) is not null ? card
                : throw new LabException($"{file}: a \"name\" of 1 to {LongestName} characters in one line is expected, and the number of the \"lab\"");
        }
        catch (JsonException e)
        {
            throw new LabException($"{file}:{e.LineNumber + 1}:{e.BytePositionInLine + 1}: this is not what \"raytracer lab new\" wrote: {{ \"Lab\": 1, \"Name\": \"Ada\", … }}");
        }
    }
}
