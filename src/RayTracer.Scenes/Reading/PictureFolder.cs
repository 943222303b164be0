using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>Loads pictures by paths relative to a folder, each only once.</summary>
internal sealed class PictureFolder(string folder, Func<string, bool, Picture> read, SceneBudget budget)
{
    private readonly Dictionary<(string Path, bool Raw), Picture> _pictures = [];

    /// <summary>Loads a picture.</summary>
    /// <param name="path">The path as it is written in the scene file.</param>
    /// <param name="raw">True where the numbers are taken as they are.</param>
    /// <exception cref="PictureException">It cannot be read.</exception>
    public Picture Load(string path, bool raw)
    {
        string full = Path.GetFullPath(Path.Combine(folder, path));
        if (_pictures.TryGetValue((full, raw), out Picture? picture))
        {
            return picture;
        }

        try
        {
            if (FileSearch.Complaint(full) is { } complaint)
            {
                throw new PictureException(complaint) { IsMissing = FileSearch.IsMissing(full) };
            }

            picture = read(Path.Combine(folder, path), raw);
            if (budget.Take($"a picture of {picture.Width}×{picture.Height} pixels", sizeof(float) * (long)picture.Pixels.Length, 0) is { } tooMuch)
            {
                throw new PictureException(tooMuch);
            }
        }
        catch (Exception e) when (e is PictureException or IOException or UnauthorizedAccessException or ArgumentException)
        {
            // Where readers name the whole path, the cause below says only what is wrong.
            string cause = e is PictureException { InnerException: { } inner } ? inner.Message : e.Message;
            throw new PictureException($"cannot read {Quotation.Of(path)}: {cause.TrimEnd('.')}", e) { IsMissing = e is PictureException { IsMissing: true } };
        }

        _pictures.Add((full, raw), picture);
        return picture;
    }
}
