using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>What films say of what the view shows.</summary>
internal static class FilmHeaders
{
    /// <summary>The header of a film, without its samples.</summary>
    /// <param name="order">What is rendered.</param>
    /// <param name="shown">What is shown.</param>
    /// <param name="place">Where the document is at home.</param>
    /// <param name="path">The film's whole path.</param>
    /// <returns>The header; and the text of the scene to write to the file that it names, where no file says what is rendered.</returns>
    /// <exception cref="SessionException">The text does not have the camera yet.</exception>
    public static (FilmHeader Header, string? Scene) Of(RenderOrder order, ShownScene shown, DocumentPlace place, string path)
    {
        if (shown.Picture != order.Picture || !DescriptionEquality.Same(order.Camera, shown.Description.Camera))
        {
            throw new SessionException("The picture is changing: write it when it has settled.", SessionFault.Refused);
        }

        FilmHeader header = new()
        {
            Width = order.Scene.Render.Width,
            Height = order.Scene.Render.Height,
            Content = PictureView.ContentOf(shown.Good, order, place.Folder),
            Samples = [],
            Wanted = new(order.First, order.Samples),
            Total = order.Scene.Render.SamplesPerPixel,
            Crop = order.Region,
            Software = ProgramName.Text,
        };
        if (order.Start?.Header is { } begun)
        {
            // What it was rendered from then, it is rendered from now.
            return (header with { Scene = begun.Scene, Settings = OldFilms.Settings(begun) }, null);
        }

        string file = Path.GetFullPath(place.Path ?? Path.Combine(place.Folder, place.Name));
        if (IsText(file, shown.Good.Text))
        {
            return (header with { Scene = file }, null);
        }

        string beside = Path.ChangeExtension(path, ".json");
        return (header with { Scene = beside }, FileNames.Move(shown.Good.Text, place.Folder, Path.GetDirectoryName(path)!));
    }

    private static bool IsText(string file, string text)
    {
        try
        {
            return File.Exists(file) && SceneFormat.Of(file) is null && !ModelFile.IsModel(file) && SceneTextFile.Read(file).Text == text;
        }
        catch (DocumentException)
        {
            return false;
        }
    }
}
