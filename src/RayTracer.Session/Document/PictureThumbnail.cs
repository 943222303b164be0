using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Picture files as small pictures, to be chosen from.</summary>
public static class PictureThumbnail
{
    private const int LargestEdge = 160;
    private const long MostPixels = 1L << 26;

    /// <summary>Returns whether a file may be one, by its name.</summary>
    public static bool IsFor(string name) => ImageFile.IsImage(name);

    /// <summary>A small picture of a file, as a PNG.</summary>
    /// <param name="path">The whole path of the file.</param>
    /// <exception cref="SessionException">It cannot be read, or is too large to be read for that alone.</exception>
    public static byte[] Png(string path)
    {
        try
        {
            ImageDescription about = IsFor(path) ? ImageFile.Describe(path) : throw new SessionException($"{Path.GetFileName(path)} is no picture.", SessionFault.Missing);
            if ((long)about.Width * about.Height > MostPixels)
            {
                throw new SessionException($"{Path.GetFileName(path)} is too large for a thumbnail.", SessionFault.Missing);
            }

            LinearPicture whole = new();
            whole.CopyFrom(ImageFile.Read(path));
            LinearPicture small = FramePixels.Reduced(whole, Math.Max(1, Math.Max(whole.Width, whole.Height) / LargestEdge));
            return ImageFile.Encode(".png", small, Tone.Plain.Writing);
        }
        catch (Exception e) when (e is PictureException or IOException or UnauthorizedAccessException)
        {
            throw new SessionException($"{Path.GetFileName(path)} cannot be read: {e.Message.TrimEnd('.')}.", e);
        }
    }
}
