using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>What to tell the user about something that went wrong.</summary>
public static class Complaint
{
    /// <summary>One sentence; null where the program itself is at fault.</summary>
    public static string? Of(Exception fault) => fault switch
    {
        DocumentException or JobException => Sentence(fault.Message),
        SessionException or ImageWriteException or PictureException or IOException or UnauthorizedAccessException => fault.Message,
        OutOfMemoryException => "There is not enough memory.",
        _ => null,
    };

    private static string Sentence(string clause) => clause.Length > 0 ? $"{char.ToUpperInvariant(clause[0])}{clause[1..].TrimEnd('.')}." : clause;
}
