namespace RayTracer.Session;

/// <summary>What is known about a frame.</summary>
/// <param name="PictureWidth">Width of the whole picture; a preview has fewer pixels.</param>
/// <param name="PictureHeight">Height of the whole picture.</param>
/// <param name="Samples">Samples in each pixel; 0 in a preview.</param>
/// <param name="IsPreview">Whether there is less in it than a sample of each pixel.</param>
/// <param name="IsLast">Whether nothing more will be added to it.</param>
/// <param name="IsLight">Whether it shows light, so that exposure and tone map apply; maps have their colours already.</param>
public sealed record FrameInfo(int PictureWidth, int PictureHeight, int Samples, bool IsPreview, bool IsLast, bool IsLight);
