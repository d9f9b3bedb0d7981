-- | Draws the pictures of docs/film.md with the program's own modules.
module Main (main) where

import BlackHole.Light.BlackBody (blackBodyColour, unmappedColour)
import BlackHole.Light.Display
import BlackHole.Light.Dither
import BlackHole.Light.Gamut
import BlackHole.Light.Radiance
import BlackHole.Light.ToneMap (ToneCurve (..), toneCurve)
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Render.Bloom
import BlackHole.Render.Exposed
import BlackHole.Render.Film
import BlackHole.Render.Optics
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import BlackHole.Scene.Camera (Camera (..), Picture (..), Pose (..))
import BlackHole.Scene.Preset (defaultScene, findPreset)
import BlackHole.Scene.Scene
import Codec.Picture (Image (..), PixelRGB8, encodePng)
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (fromMaybe, mapMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word8)
import System.Environment (getArgs)
import System.Exit (die)
import System.FilePath ((</>))

-- | A picture: width, height, and the code as a function of column, row and channel.
data Sheet = Sheet !Int !Int (Int -> Int -> Int -> Word8)

main :: IO ()
main = do
  arguments <- getArgs
  let folder = case arguments of
        given : _ -> given
        [] -> "docs/images"
  workers <- defaultWorkers
  withWorkers workers $ do
    exposed <-
      exposeFilm
        Nothing
        workers
        (const (pure ()))
        defaultScene {scenePicture = Picture wide high, sceneSamples = 4}
        (0, high)
    film <- maybe (die "the default scene cannot be traced") (pure . exposedLight) exposed
    toneMaps <-
      mapM
        (\tone -> sheetOf <$> developFilm workers (Development plain tone noGrain BlueNoise) film)
        [ToneFilm, ToneNone, ToneReinhard, ToneAces, ToneAgx]
    write folder "film-tone-maps.png" (inRows 2 (toneMaps ++ [channelByChannel film]))
    write folder "film-hue.png" (inRows 1 [wedge byChannel, wedge (applyToneMap ToneFilm)])
    write folder "film-red.png" (inRows 1 [strip towardsWhite, strip desaturateIntoGamut])
    dithers <-
      mapM
        ( \dither ->
            brightened . sheetOf
              <$> developFilm workers (Development (Exposure (-6)) ToneFilm noGrain dither) film
        )
        [NoDither, BlueNoise]
    write folder "film-dither.png" (inRows 2 dithers)
    blooms <-
      mapM
        ( \strength ->
            bloomFilm workers strength film
              >>= fmap sheetOf . developFilm workers (Development plain ToneFilm noGrain BlueNoise)
        )
        [0, 0.08, 0.2, 0.5]
    write folder "film-bloom.png" (inRows 2 blooms)
    instruments <- mapM (recorded workers) (instrumentScenes wide high)
    write folder "film-instrument.png" (inRows 2 instruments)
  where
    plain = Exposure 0
    wide = 480
    high = 270

-- | The scenes that show spikes, grain, beam and depth of field.
instrumentScenes :: Int -> Int -> [Scene]
instrumentScenes wide high =
  [ scene {scenePicture = Picture wide high}
    | scene <-
        [defaultScene {sceneSpikes = 6, sceneSpikeLight = 0.2}]
          ++ mapMaybe findPreset ["luminet", "m87"]
          ++ [ defaultScene
                 { sceneCamera =
                     Camera (Around 20 (Degrees 82) (Degrees 90)) (Degrees (-8)) (Degrees 60),
                   sceneAperture = 1.2,
                   sceneFocus = 8,
                   sceneSamples = 32,
                   sceneMostSamples = 128
                 }
             ]
  ]

recorded :: Workers -> Scene -> IO Sheet
recorded workers scene = do
  exposed <-
    exposeFilm Nothing workers (const (pure ())) scene (0, pictureHeight (scenePicture scene))
  film <- maybe (die "a scene cannot be traced") (opticsFilm workers scene . exposedLight) exposed
  sheetOf <$> developFilm workers (sceneDevelopment scene) film

sheetOf :: PixelArray Word8 -> Sheet
sheetOf codes =
  Sheet width (shapeHeight shape) (\x y k -> Vector.unsafeIndex numbers (3 * (y * width + x) + k))
  where
    shape = pixelArrayShape codes
    width = shapeWidth shape
    numbers = toPixelVector codes

-- | The film curve applied to each primary separately, as most programs do.
byChannel :: Radiance -> Radiance
byChannel light = case toneCurve ToneFilm of
  Just (ToneCurve _ _ curve) -> mapRadiance curve light
  Nothing -> light

channelByChannel :: Film -> Sheet
channelByChannel film =
  lightSheet width (shapeHeight shape) (\x y -> byChannel (fromMaybe black (filmRadiance film x y)))
  where
    shape = pixelArrayShape film
    width = shapeWidth shape

-- | Converts display light, 0 to 1, to codes.
lightSheet :: Int -> Int -> (Int -> Int -> Radiance) -> Sheet
lightSheet width height light = Sheet width height code
  where
    code x y k = case light x y of
      Radiance r g b -> quantise (encodeSrgb (if k == 0 then r else if k == 1 then g else b))

-- | Black bodies from 1000 K (left) to 10000 K (right), from 3 stops below display
-- white (bottom) to 5 above (top).
wedge :: (Radiance -> Radiance) -> Sheet
wedge shown = lightSheet 720 180 $ \x y ->
  let temperature = 1000 * 10 ** (fromIntegral x / 720)
      stops = 5 - 8 * fromIntegral y / 180
   in shown (scaleRadiance (2 ** stops) (blackBodyColour temperature))

-- | Black bodies from 300 to 2000 K, each as bright as possible.
strip :: (Radiance -> Radiance) -> Sheet
strip mapped = lightSheet 720 60 $ \x _ ->
  let light@(Radiance r g b) = mapped (unmappedColour (300 + 1700 * fromIntegral x / 720))
   in scaleRadiance (1 / max r (max g b)) light

-- | Mixes in white until no component is negative, whichever component that is.
towardsWhite :: Radiance -> Radiance
towardsWhite light@(Radiance r g b) =
  mapRadiance (\c -> max 0 (y + (c - y) * y / (y - least))) light
  where
    y = luminance light
    least = min 0 (min r (min g b))

-- | The lower right quarter at twice its size, with codes six times as far apart.
brightened :: Sheet -> Sheet
brightened (Sheet width height code) =
  Sheet
    width
    height
    ( \x y k ->
        let c =
              fromIntegral (code ((width + x) `quot` 2) ((height + y) `quot` 2) k) :: Int
         in fromIntegral (min 255 (6 * c))
    )

-- | Sheets in rows of this many, separated by white lines.
inRows :: Int -> [Sheet] -> Sheet
inRows across sheets = Sheet (across * (width + gap) - gap) (down * (height + gap) - gap) code
  where
    gap = 6
    down = (length sheets + across - 1) `quot` across
    (width, height) = case sheets of
      Sheet w h _ : _ -> (w, h)
      [] -> (1, 1)
    code x y k =
      let (column, inX) = x `quotRem` (width + gap)
          (row, inY) = y `quotRem` (height + gap)
       in case drop (row * across + column) sheets of
            Sheet _ _ own : _ | inX < width && inY < height -> own inX inY k
            _ -> 255

write :: FilePath -> String -> Sheet -> IO ()
write folder name (Sheet width height code) =
  Lazy.writeFile (folder </> name) (encodePng (Image width height codes :: Image PixelRGB8))
  where
    codes =
      Vector.generate
        (3 * width * height)
        (\i -> let (pixel, k) = i `quotRem` 3; (y, x) = pixel `quotRem` width in code x y k)
