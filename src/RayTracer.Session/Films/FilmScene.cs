using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>The scene file that a film of what the view shows names.</summary>
/// <param name="File">The file.</param>
/// <param name="Text">The text to write to it; null where it says what is rendered.</param>
internal sealed record FilmScene(string File, string? Text)
{
    /// <summary>Returns the document's file, or one beside the film where that has another text.</summary>
    /// <param name="shown">The scene that is shown.</param>
    /// <param name="camera">The camera that the film is rendered with.</param>
    /// <param name="place">The document's name and folder.</param>
    /// <param name="film">The film's whole path.</param>
    /// <exception cref="SessionException">The text does not have the camera.</exception>
    public static FilmScene Of(ViewportScene shown, CameraDescription camera, DocumentPlace place, string film)
    {
        if (!DescriptionEquality.Same(camera, shown.Description.Camera))
        {
            throw new SessionException("A film is of a scene's camera, not of a view beside it: set the scene's camera to the view first.", SessionFault.Refused);
        }

        string file = Path.GetFullPath(place.Path ?? Path.Combine(place.Folder, place.Name));
        return IsText(file, shown.Good.Text)
            ? new(file, null)
            : new(Path.ChangeExtension(film, ".json"), FileNames.Move(shown.Good.Text, place.Folder, Path.GetDirectoryName(film)!));
    }

    /// <summary>The complaint about a picture that does not show what the text says yet.</summary>
    public static SessionException Changing() => new("The picture is changing: write it when it has settled.", SessionFault.Refused);

    /// <summary>Writes the text, where it has to be written.</summary>
    public void Write()
    {
        if (Text is not null)
        {
            SceneTextFile.Write(File, Text, "\n");
        }
    }

    private static bool IsText(string file, string text)
    {
        try
        {
            return System.IO.File.Exists(file) && SceneFormat.Of(file) is null && !ModelFile.IsModel(file)
                && SceneTextFile.Read(file).Text == text;
        }
        catch (SessionException)
        {
            return false;
        }
    }
}
