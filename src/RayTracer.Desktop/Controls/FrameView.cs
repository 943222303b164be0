using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Platform;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Controls;

/// <summary>Shows pixels, as large as it is itself.</summary>
internal sealed class FrameView : Control
{
    /// <summary>The pixels; null for none.</summary>
    public static readonly StyledProperty<PixelFrame?> FrameProperty = AvaloniaProperty.Register<FrameView, PixelFrame?>(nameof(Frame));

    // The newest one goes with the view: controls are not disposed of.
    private IImage? _image;

    /// <summary>The pixels; null for none.</summary>
    public PixelFrame? Frame
    {
        get => GetValue(FrameProperty);
        set => SetValue(FrameProperty, value);
    }

    /// <summary>The bitmap that it draws.</summary>
    internal WriteableBitmap? Bitmap => _image as WriteableBitmap;

    /// <inheritdoc/>
    public override void Render(DrawingContext context)
    {
        if (Bitmap is { } bitmap && Frame is not null)
        {
            context.DrawImage(bitmap, new Rect(bitmap.Size), new Rect(Bounds.Size));
        }
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        base.OnPropertyChanged(change);
        if (change.Property == FrameProperty)
        {
            Copy(Frame);
            InvalidateVisual();
        }

        if (change.Property == FrameProperty || change.Property == BoundsProperty)
        {
            // Enlarged pixels are to be seen as what they are.
            bool isEnlarged = Bitmap is { } bitmap && Bounds.Width > bitmap.PixelSize.Width;
            RenderOptions.SetBitmapInterpolationMode(this, isEnlarged ? BitmapInterpolationMode.None : BitmapInterpolationMode.HighQuality);
        }
    }

    private void Copy(PixelFrame? frame)
    {
        if (frame is null)
        {
            return;
        }

        PixelSize size = new(frame.Width, frame.Height);
        if (Bitmap is not { } bitmap || bitmap.PixelSize != size)
        {
            Bitmap?.Dispose();
            _image = bitmap = new(size, new(96, 96), PixelFormat.Rgba8888, AlphaFormat.Unpremul);
        }

        using ILockedFramebuffer pixels = bitmap.Lock();
        for (int y = 0; y < frame.Height; y++)
        {
            Marshal.Copy(frame.Rgba, 4 * frame.Width * y, pixels.Address + (y * pixels.RowBytes), 4 * frame.Width);
        }
    }
}
