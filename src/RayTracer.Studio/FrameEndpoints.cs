using System.Buffers;
using System.Buffers.Binary;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The picture, for pages that wait for its changes: always the newest frame, in bytes that a canvas takes.</summary>
internal static class FrameEndpoints
{
    private const uint Magic = 0x31465452; // "RTF1"
    private const int HeaderBytes = 32;
    private const uint IsPreview = 1;
    private const uint IsLast = 2;
    private const int DocumentShift = 8;

    /// <summary>Adds the requests.</summary>
    public static void MapFrames(this RouteGroupBuilder api, PictureView view, LongPoll poll) =>
        api.MapGet("/frame", async (long? after, int? width, int? height, HttpContext context) =>
        {
            bool isNew = await poll.Wait(view.Frames.Wait, after ?? 0, context.RequestAborted);
            using FrameLease? frame = isNew ? view.Frames.Borrow() : null;
            if (frame is null)
            {
                context.Response.StatusCode = StatusCodes.Status204NoContent;
                return;
            }

            await Send(context.Response, frame, view.Tone, FramePixels.Reduction(frame.Picture, width ?? 0, height ?? 0), context.RequestAborted);
        });

    private static async Task Send(HttpResponse response, FrameLease frame, Tone tone, int reduction, CancellationToken aborted)
    {
        (int width, int height) = (frame.Picture.Width / reduction, frame.Picture.Height / reduction);
        int length = HeaderBytes + (4 * width * height);
        byte[] bytes = ArrayPool<byte>.Shared.Rent(length);
        try
        {
            WriteHeader(bytes, frame, width, height);
            FramePixels.Write(frame.Picture, frame.Info.IsLight ? tone : Tone.Plain, reduction, bytes.AsMemory(HeaderBytes, length - HeaderBytes));
            response.ContentType = "application/octet-stream";
            response.ContentLength = length;
            await response.Body.WriteAsync(bytes.AsMemory(0, length), aborted);
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(bytes);
        }
    }

    private static void WriteHeader(Span<byte> header, FrameLease frame, int width, int height)
    {
        uint flags = (frame.Info.IsPreview ? IsPreview : 0) | (frame.Info.IsLast ? IsLast : 0) | ((uint)frame.Document << DocumentShift);
        uint[] numbers = [Magic, (uint)frame.Version, (uint)width, (uint)height, (uint)frame.Info.PictureWidth, (uint)frame.Info.PictureHeight, flags, (uint)frame.Info.Samples];
        for (int i = 0; i < numbers.Length; i++)
        {
            BinaryPrimitives.WriteUInt32LittleEndian(header[(4 * i)..], numbers[i]);
        }
    }
}
